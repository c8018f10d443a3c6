/* The gyro's FMU, compiled to WebAssembly: its own FMI 2 functions, called from a script. */
"use strict";

const CO_SIMULATION = 1;
const OK = 0;

/* Loads the library. `binary` has `wasm` (base64), `guid`, `variables` (value references), and
   `integers` (names of those that are no real numbers). */
async function loadLibrary(binary) {
  const bytes = Uint8Array.from(atob(binary.wasm), (c) => c.charCodeAt(0));
  const { instance } = await WebAssembly.instantiate(bytes);
  const functions = instance.exports;
  functions._initialize();
  const reference = functions.malloc(4);
  const number = functions.malloc(8);
  const guid = writeText(functions, binary.guid);
  const integers = new Set(binary.integers);
  return { functions, reference, number, guid, variables: binary.variables, integers };
}

function writeText(functions, text) {
  const bytes = new TextEncoder().encode(text + "\0");
  const place = functions.malloc(bytes.length);
  new Uint8Array(functions.memory.buffer).set(bytes, place);
  return place;
}

/* One gyro. Parameters are set before `start`, inputs at any time; all are in SI. */
class Gyro {
  constructor(library) {
    this.library = library;
    const { functions, guid } = library;
    this.instance = functions.fmi2Instantiate(guid, CO_SIMULATION, guid, guid, 0, 0, 0);
    if (!this.instance) throw new Error("the gyro could not be made");
    this.check(functions.fmi2SetupExperiment(this.instance, 0, 0, 0, 0, 0));
    this.time = 0;
  }

  check(status) {
    if (status !== OK) throw new Error("the gyro refused a call");
  }

  point(name) {
    const { functions, reference, variables } = this.library;
    if (!(name in variables)) throw new Error(`no variable ${name}`);
    new Uint32Array(functions.memory.buffer, reference, 1)[0] = variables[name];
  }

  set(name, value) {
    const { functions, reference, number, integers } = this.library;
    const [Numbers, setNumbers] = integers.has(name)
      ? [Int32Array, functions.fmi2SetInteger]
      : [Float64Array, functions.fmi2SetReal];
    this.point(name);
    new Numbers(functions.memory.buffer, number, 1)[0] = value;
    this.check(setNumbers(this.instance, reference, 1, number));
  }

  get(name) {
    const { functions, reference, number } = this.library;
    this.point(name);
    this.check(functions.fmi2GetReal(this.instance, reference, 1, number));
    return new Float64Array(functions.memory.buffer, number, 1)[0];
  }

  start() {
    this.check(this.library.functions.fmi2EnterInitializationMode(this.instance));
    this.check(this.library.functions.fmi2ExitInitializationMode(this.instance));
  }

  advance(step) {
    this.check(this.library.functions.fmi2DoStep(this.instance, this.time, step, 1));
    this.time += step;
  }

  free() {
    this.library.functions.fmi2FreeInstance(this.instance);
  }
}

globalThis.loadLibrary = loadLibrary;
globalThis.Gyro = Gyro;
