/* The page of the gyro: the turning table, the sliders of its mechanisms, the two tests. */
"use strict";

const DEGREE = Math.PI / 180;
const DEG_PER_H = DEGREE / 3600;
const REST_S = 300;
const POSITIONS = 24;
const HOUR_RESTS = 12;

/* Mechanisms: label, parameter, unit of the slider in SI, and range of the slider. */
const MECHANISMS = [
  ["Damping anisotropy, 1e-7 1/s", "resonator.material.dampingAnisotropy", 1e-7, 0, 50],
  ["Damping axis, deg", "resonator.material.dampingAxis", DEGREE, -90, 90],
  ["Mismatch of the drives, ppm", "drive.gainMismatch", 1e-6, -200, 200],
  ["Mismatch of the pick-offs, ppm", "pickOff.gainMismatch", 1e-6, -200, 200],
];
const STILL = matchMedia("(prefers-reduced-motion: reduce)");

const find = (id) => document.getElementById(id);
const values = { ...GYRO.parameters };
let library = null;
let turning = null;
let tableAngle = 0;
let shownAt = 0;
let run = 0;

function makeGyro(startAngle, seed) {
  const gyro = new Gyro(library);
  for (const [name, value] of Object.entries(values)) gyro.set(name, value);
  gyro.set("startAngle", startAngle);
  if (seed) gyro.setSeed(seed);
  gyro.start();
  return gyro;
}

function restart() {
  const angle = turning ? turning.get("patternAngle") : 0;
  if (turning) turning.free();
  turning = makeGyro(angle, 0);
  run += 1;
  find("verdict").textContent = "";
  drawMap([], []);
}

function addSlider([label, name, unit, low, high]) {
  const row = document.createElement("p");
  const input = Object.assign(document.createElement("input"), { type: "range", min: low, max: high });
  input.step = "0.5";
  const shown = document.createElement("output");
  const title = document.createElement("label");
  input.value = String(values[name] / unit);
  const show = () => (shown.textContent = input.value);
  input.addEventListener("input", show);
  input.addEventListener("change", () => {
    values[name] = Number(input.value) * unit;
    restart();
  });
  title.append(label, " ", input);
  row.append(title, " ", shown);
  find("mechanisms").append(row);
  show();
}

/* The rim seen from above at a slant, the case's mark on it, and the wave, much enlarged. */
function drawRim() {
  const canvas = find("rim");
  const draw = canvas.getContext("2d");
  const color = getComputedStyle(canvas).color;
  const wave = turning.get("patternAngle") + tableAngle;
  const swing = STILL.matches ? 1 : Math.sin(shownAt / 60);
  const place = (angle, radius) => [
    canvas.width / 2 + radius * Math.cos(angle),
    150 - 0.55 * radius * Math.sin(angle),
  ];
  const ring = (radius) => {
    draw.beginPath();
    for (let i = 0; i <= 180; i++) draw.lineTo(...place(2 * i * DEGREE, radius(2 * i * DEGREE)));
    draw.stroke();
  };
  draw.clearRect(0, 0, canvas.width, canvas.height);
  draw.strokeStyle = draw.fillStyle = color;
  draw.globalAlpha = 0.4;
  draw.lineWidth = 1;
  ring(() => 190);
  draw.beginPath();
  draw.ellipse(canvas.width / 2, 150, 190, 215, 0, 0, Math.PI);
  draw.stroke();
  draw.globalAlpha = 1;
  draw.lineWidth = 3;
  draw.strokeStyle = "#c25a1b";
  ring((angle) => 190 + 34 * Math.cos(2 * (angle - wave)) * swing);
  draw.fillStyle = color;
  draw.beginPath();
  draw.arc(...place(tableAngle, 240), 7, 0, 2 * Math.PI);
  draw.fill();
  draw.font = "16px sans-serif";
  draw.fillText("case", ...place(tableAngle, 262));
}

/* Bias of each position over the pattern angle, and of the fixed position, which is larger. */
function drawMap(points, fixed) {
  const canvas = find("map");
  const draw = canvas.getContext("2d");
  const color = getComputedStyle(canvas).color;
  const largest = Math.max(0.01, ...[...points, ...fixed].map(([, bias]) => Math.abs(bias)));
  const x = (angle) => 70 + ((canvas.width - 90) * angle) / 180;
  const y = (bias) => 165 - (130 * bias) / largest;
  draw.clearRect(0, 0, canvas.width, canvas.height);
  draw.strokeStyle = draw.fillStyle = color;
  draw.font = "16px sans-serif";
  draw.textAlign = "right";
  for (const bias of [-largest, 0, largest]) {
    draw.fillText(bias.toPrecision(2), 62, y(bias) + 5);
    draw.fillRect(70, y(bias), canvas.width - 90, 0.5);
  }
  draw.textAlign = "center";
  for (let angle = 0; angle <= 180; angle += 45) draw.fillText(String(angle), x(angle), 325);
  draw.fillText("bias, deg/h, over the pattern angle, deg", canvas.width / 2, 350);
  const mark = ([angle, bias], size, fill) => {
    draw.fillStyle = fill;
    draw.beginPath();
    draw.arc(x(angle), y(bias), size, 0, 2 * Math.PI);
    draw.fill();
  };
  fixed.forEach((point) => mark(point, 9, "#c25a1b"));
  points.forEach((point) => mark(point, 5, "#2a6f97"));
}

function measureBias(gyro) {
  const before = gyro.get("gyroAngle");
  gyro.advance(REST_S);
  return (gyro.get("gyroAngle") - before) / REST_S / DEG_PER_H;
}

function computeDeviation(numbers) {
  const mean = numbers.reduce((sum, n) => sum + n, 0) / numbers.length;
  return Math.sqrt(numbers.reduce((sum, n) => sum + (n - mean) ** 2, 0) / (numbers.length - 1));
}

/* Amplitude of a harmonic of the pattern angle in biases at evenly spaced angles of half a turn. */
function fitAmplitude(biases, harmonic) {
  let [cosine, sine] = [0, 0];
  biases.forEach((bias, i) => {
    const angle = (harmonic * i * Math.PI) / biases.length;
    cosine += (2 / biases.length) * bias * Math.cos(angle);
    sine += (2 / biases.length) * bias * Math.sin(angle);
  });
  return Math.hypot(cosine, sine);
}

/* Position error of three such gyros, nmi, by the linear mission model; their mean is taken out. */
function predictError(biases) {
  const parts = Object.entries(GYRO.worth).map(([h, worth]) => worth * fitAmplitude(biases, Number(h)));
  return Math.hypot(...parts);
}

const nextFrame = () => new Promise((resolve) => requestAnimationFrame(resolve));
const inHalfTurn = (angle) => ((((angle / DEGREE) % 180) + 180) % 180);

async function runTests() {
  const mine = ++run;
  const resting = makeGyro(turning.get("patternAngle"), 1);
  const angle = inHalfTurn(resting.get("patternAngle"));
  const hour = Array.from({ length: HOUR_RESTS }, () => measureBias(resting));
  resting.free();
  const fixed = computeDeviation(hour);
  const rested = [[angle, hour.reduce((sum, bias) => sum + bias, 0) / HOUR_RESTS]];
  const points = [];
  for (let i = 0; i < POSITIONS; i++) {
    const gyro = makeGyro((i * Math.PI) / POSITIONS, 2 + i);
    points.push([inHalfTurn(gyro.get("patternAngle")), measureBias(gyro)]);
    gyro.free();
    drawMap(points, rested);
    await nextFrame();
    if (mine !== run) return;
  }
  const biases = points.map(([, bias]) => bias);
  const all = computeDeviation(biases);
  const flown = predictError(biases);
  const promise = (stability) => ((stability / 0.01) * 2).toPrecision(2);
  const ratio = all / fixed;
  const times = ratio < 10 ? ratio.toFixed(1) : Math.round(ratio);
  find("verdict").textContent =
    `The fixed position promises ${fixed.toPrecision(2)} deg/h. The full circumference shows ` +
    `${all.toPrecision(2)} deg/h, ${times} times as much. By the usual rule, 0.01 deg/h makes ` +
    `1 nmi/h: that is ${promise(fixed)} and ${promise(all)} nmi after 2 h. Three such gyros in a ` +
    `car, their mean taken out, err by ${flown.toPrecision(2)} nmi, by the linear mission model.`;
}

function advance(now) {
  const passed = Math.min((now - shownAt) / 1000, 0.1);
  shownAt = now;
  const rate = Number(find("rate").value);
  find("rate-value").textContent = `${rate}`;
  if (passed > 0) {
    turning.set("angularRate", rate * DEGREE);
    turning.advance(passed);
    tableAngle += rate * DEGREE * passed;
  }
  drawRim();
  const deg = (angle) => (angle / DEGREE).toFixed(1);
  find("state").textContent =
    `Table ${deg(tableAngle)} deg. Wave in the case ${deg(turning.get("patternAngle"))} deg.`;
  requestAnimationFrame(advance);
}

async function begin() {
  library = await loadLibrary(GYRO);
  MECHANISMS.forEach(addSlider);
  restart();
  find("run").addEventListener("click", runTests);
  requestAnimationFrame((now) => {
    shownAt = now;
    advance(now);
  });
}

begin();
