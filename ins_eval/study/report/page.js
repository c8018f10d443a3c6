"use strict";
(() => {
  const study = JSON.parse(document.getElementById("study").textContent);
  const form = document.getElementById("filters");
  const tip = document.getElementById("tip");
  const panels = [...document.querySelectorAll("figure[data-panel]")];
  const charts = [...document.querySelectorAll("svg[data-x]")];
  const KEYS = { calibration: "calibration", class: "mission_class" };
  const chosen = () => Object.fromEntries(new FormData(form));
  const name = (column, row) => {
    const { levels, codes } = study.names[column];
    return levels[codes[row]];
  };
  const rounded = (value) => Number(value.toPrecision(3)).toLocaleString("en");
  const distance = (value) =>
    value === null ? "none" : `${rounded(value)} nmi (${rounded(1.852 * value)} km)`;

  let rows = [];

  function applies(element, choice) {
    return Object.keys(KEYS).every((key) => {
      const own = element.dataset[key];
      return !own || choice[key] === "all" || choice[key] === own;
    });
  }

  function filter() {
    const choice = chosen();
    for (const element of document.querySelectorAll("[data-class],[data-calibration]"))
      element.toggleAttribute("hidden", !applies(element, choice));
    rows = study.triad
      .map((_, row) => row)
      .filter((row) => Object.entries(KEYS).every(
        ([key, column]) => choice[key] === "all" || choice[key] === name(column, row)));
    for (const panel of panels) caption(panel, choice);
    explain(choice);
    document.getElementById("predictions").classList.toggle("one", choice.predictor !== "all");
    leave();
  }

  function caption(panel, choice) {
    const own = panel.dataset.panel;
    const ranking = own.startsWith("rank_");
    panel.toggleAttribute("hidden",
      !ranking && choice.predictor !== "all" && choice.predictor !== own);
    const svg = panel.querySelector("svg[data-x]");
    const count = svg ? rows.filter((row) => place(svg, row)).length : 0;
    const scores = study.captions[[own, choice.calibration, choice.class].join("|")];
    panel.querySelector(".live").textContent =
      [ranking ? "" : `${count.toLocaleString("en")} flights`, scores].filter(Boolean).join("; ");
  }

  function explain(choice) {
    const empty = document.getElementById("empty");
    const said = [choice.class, choice.calibration].filter((value) => value !== "all").join(", ");
    empty.hidden = rows.length > 0;
    empty.textContent = empty.hidden ? "" :
      `No judged flight of this study is of this selection (${said}): choose "all" in one of them.`;
    for (const table of document.querySelectorAll("table.matrix")) {
      const shown = [...table.querySelectorAll("tbody tr")].some((row) => !row.hidden);
      table.nextElementSibling?.remove();
      if (!shown) table.insertAdjacentHTML("afterend",
        '<p class="none">Nothing here is of the selection above.</p>');
    }
    cue();
  }

  function cue() {
    for (const box of document.querySelectorAll(".wide"))
      box.classList.toggle("over", box.scrollWidth > box.clientWidth + 1);
  }

  function place(svg, row) {
    const [low, high] = svg.dataset.range.split(" ").map((v) => Math.log10(Number(v)));
    const along = (column, start, end) => {
      const value = study.numbers[column][row];
      if (!(value > 0)) return NaN;
      return start + ((Math.log10(value) - low) / (high - low)) * (end - start);
    };
    const [left, right, bottom, top] = svg.dataset.plot.split(" ").map(Number);
    const x = along(svg.dataset.x, left, right);
    const y = along(svg.dataset.y, bottom, top);
    return Number.isFinite(x + y) ? { x, y } : null;
  }

  function nearest(svg, event) {
    const point = new DOMPoint(event.clientX, event.clientY)
      .matrixTransform(svg.getScreenCTM().inverse());
    let best = null, distance = 20 ** 2;
    for (const row of rows) {
      const at = place(svg, row);
      const d = at ? (at.x - point.x) ** 2 + (at.y - point.y) ** 2 : Infinity;
      if (d < distance) [best, distance] = [row, d];
    }
    return best;
  }

  function show(svg, row) {
    if (row === null) return leave();
    for (const svg of charts) mark(svg, row);
    tip.textContent = [
      `Triad ${study.triad[row]}, ${name("mission", row)} (${name("mission_class", row)})`,
      `${name("calibration", row)} calibrated, ${name("flown_by", row)}`,
      `predicted ${distance(study.numbers[svg.dataset.x][row])}`,
      `flown ${distance(study.numbers[svg.dataset.y][row])}`,
    ].join("\n");
    tip.hidden = false;
    const at = place(svg, row);
    const on = new DOMPoint(at.x, at.y).matrixTransform(svg.getScreenCTM());
    tip.style.left = `${Math.max(4, Math.min(on.x + 14, innerWidth - tip.offsetWidth - 4))}px`;
    tip.style.top = `${Math.max(4, Math.min(on.y + 14, innerHeight - tip.offsetHeight - 4))}px`;
  }

  function mark(svg, row) {
    const at = place(svg, row);
    const circle = svg.querySelector(".mark");
    circle.setAttribute("visibility", at ? "visible" : "hidden");
    if (!at) return;
    circle.setAttribute("cx", at.x);
    circle.setAttribute("cy", at.y);
  }

  function leave() {
    tip.hidden = true;
    for (const circle of document.querySelectorAll(".mark"))
      circle.setAttribute("visibility", "hidden");
  }

  function stepped(svg, state, event) {
    const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
    if (event.key === "Escape") return leave();
    if (!(event.key in steps)) return;
    event.preventDefault();
    const flown = study.numbers[svg.dataset.y];
    const order = rows.filter((row) => place(svg, row)).sort((a, b) => flown[a] - flown[b]);
    if (!order.length) return;
    const at = order.indexOf(state.row);
    const next = at < 0 ? 0 : (at + steps[event.key] + order.length) % order.length;
    state.row = order[next];
    show(svg, state.row);
  }

  for (const svg of charts) {
    const state = { row: null };
    svg.addEventListener("pointermove", (event) => {
      state.row = nearest(svg, event);
      show(svg, state.row);
    });
    svg.addEventListener("pointerleave", leave);
    svg.addEventListener("blur", leave);
    svg.addEventListener("keydown", (event) => stepped(svg, state, event));
  }
  form.addEventListener("change", filter);
  addEventListener("resize", cue);
  document.addEventListener("toggle", cue, true);
  form.addEventListener("submit", (event) => event.preventDefault());
  addEventListener("beforeprint", () => {
    for (const fold of document.querySelectorAll("details")) fold.open = true;
  });
  form.hidden = false;
  filter();
})();
(() => {
  const study = JSON.parse(document.getElementById("constants").textContent);
  const form = document.getElementById("own-gyro");
  const output = document.getElementById("own-error");
  const short = (value) => {
    const rounded = Number((value * (1 + 1e-12)).toPrecision(2));
    return value < 1e-3 ? String(rounded)
      : rounded.toLocaleString("en", { maximumSignificantDigits: 2 });
  };
  const both = (show) => `${show(1852)} nmi (${show(1000)} km)`;
  const fill = (text, values) => text.replace(/{(\w+)}/g, (_, key) => values[key]);

  function predict(constant, stability) {
    const rule = study.metres_per_deg_h * stability * constant.hours;
    const [median, low, high] = constant.ratios.map((ratio) => rule * ratio);
    const [smallest, largest] = constant.ends;
    const beyond = stability < smallest || stability > largest
      ? fill(study.beyond, { smallest: short(smallest), largest: short(largest) }) : "";
    return fill(study.sentence, {
      ...constant, beyond, stability, level: study.level,
      median: both((unit) => short(median / unit)),
      range: both((unit) => `${short(low / unit)} to ${short(high / unit)}`),
      rule: both((unit) => short(rule / unit)),
    });
  }

  function answer() {
    const given = Object.fromEntries(new FormData(form));
    const chosen = study.constants.filter((each) =>
      each.mission === given.mission && each.calibration === given.calibration);
    const lines = chosen.filter((each) => given[each.key].trim()).map((each) => {
      const typed = given[each.key].trim(), stability = Number(typed);
      const [low, high] = study.range;
      return stability >= low && stability <= high ? predict(each, stability)
        : `${each.test}: found ${typed}, expected a number from ${low} to ${high} deg/h`;
    });
    const empty = chosen.length ? "Type a bench figure."
      : "This study has no constants of this mission and calibration.";
    output.replaceChildren(...(lines.length ? lines : [empty]).map((line) =>
      Object.assign(document.createElement("p"), { textContent: line })));
  }

  form.addEventListener("input", answer);
  form.addEventListener("submit", (event) => event.preventDefault());
  form.hidden = false;
  answer();
})();
