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
  ["Non-orthogonality of the drives, urad", "drive.nonOrthogonality", 1e-6, -200, 200],
  ["Non-orthogonality of the pick-offs, urad", "pickOff.nonOrthogonality", 1e-6, -200, 200],
  ["Frequency split, mHz", "resonator.material.frequencySplit", 2e-3 * Math.PI, 0, 5],
  ["Phase error of the pick-offs, urad", "pickOff.phaseError", 1e-6, -200, 200],
];
/* Height of the text on the screen, px, on a phone as on a desk. */
const TEXT_PX = 13;
const STILL = matchMedia("(prefers-reduced-motion: reduce)");

const find = (id) => document.getElementById(id);
const values = { ...GYRO.parameters };
let library = null;
let turning = null;
let tableAngle = 0;
let shownAt = 0;
let run = 0;
const sliders = [];

function makeGyro(startAngle, seed) {
  const gyro = new Gyro(library);
  for (const [name, value] of Object.entries(values)) gyro.set(name, value);
  gyro.set("startAngle", startAngle);
  if (seed) gyro.set("seed", seed);
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
  const show = () => (shown.textContent = input.value);
  input.addEventListener("input", show);
  input.addEventListener("change", () => {
    values[name] = Number(input.value) * unit;
    restart();
  });
  sliders.push(() => {
    input.value = String(values[name] / unit);
    show();
  });
  sliders.at(-1)();
  title.append(label, " ", input);
  row.append(title, " ", shown);
  find("mechanisms").append(row);
}

/* Set every error to zero, or all to those that the page began with. */
function setMechanisms(from) {
  for (const [, name] of MECHANISMS) values[name] = from[name] ?? 0;
  for (const follow of sliders) follow();
  restart();
}

function setText(canvas) {
  const size = (TEXT_PX * canvas.width) / (canvas.clientWidth || canvas.width);
  canvas.getContext("2d").font = `${size}px sans-serif`;
  return size;
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
  draw.fillStyle = "#c25a1b";
  const dot = (angle, radius) => {
    draw.beginPath();
    draw.arc(...place(angle, radius), 7, 0, 2 * Math.PI);
    draw.fill();
  };
  for (let i = 0; i < 4; i++) dot(wave + (i * Math.PI) / 2, 190);
  draw.fillStyle = color;
  dot(tableAngle, 240);
  const size = setText(canvas);
  draw.textAlign = "center";
  const [left, top] = place(tableAngle, 240);
  const isHigh = top < 2 * size;
  draw.fillText("case", left, isHigh ? top + 1.5 * size : top - 0.8 * size);
}

/* Bias of each position over the pattern angle, and of the fixed position, which is larger. */
function drawMap(points, fixed) {
  const canvas = find("map");
  const draw = canvas.getContext("2d");
  const color = getComputedStyle(canvas).color;
  const largest = Math.max(0.01, ...[...points, ...fixed].map(([, bias]) => Math.abs(bias)));
  const size = setText(canvas);
  const left = 4.8 * size;
  const [top, bottom] = [2.2 * size, canvas.height - 3.4 * size];
  const right = canvas.width - size;
  const x = (angle) => left + ((right - left) * angle) / 180;
  const y = (bias) => (top + bottom) / 2 - (0.5 * (bottom - top) * bias) / largest;
  draw.clearRect(0, 0, canvas.width, canvas.height);
  draw.strokeStyle = draw.fillStyle = color;
  draw.textAlign = "right";
  for (const share of [-1, -0.5, 0, 0.5, 1]) {
    const bias = share * largest;
    draw.fillText(share ? bias.toPrecision(2) : "0", left - 0.5 * size, y(bias) + 0.3 * size);
    draw.fillRect(left, y(bias), right - left, 0.5);
  }
  draw.textAlign = "center";
  for (let angle = 0; angle <= 180; angle += 45) {
    draw.fillText(String(angle), Math.min(x(angle), right - 0.6 * size), bottom + 1.6 * size);
  }
  draw.fillText("pattern angle, deg", (left + right) / 2, bottom + 3 * size);
  draw.textAlign = "left";
  draw.fillText("bias, deg/h", left, size);
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
  const typical = { ...values };
  MECHANISMS.forEach(addSlider);
  restart();
  find("ideal").addEventListener("click", () => setMechanisms({}));
  find("typical").addEventListener("click", () => setMechanisms(typical));
  find("run").addEventListener("click", runTests);
  requestAnimationFrame((now) => {
    shownAt = now;
    advance(now);
  });
}

begin();
