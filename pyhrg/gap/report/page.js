"use strict";
(() => {
  const form = document.getElementById("filters");
  const figures = [...document.querySelectorAll("figure[data-test]")];
  const groups = [...document.querySelectorAll("[data-group]")];
  const none = document.getElementById("none");

  function pick() {
    const { view, test, axis } = Object.fromEntries(new FormData(form));
    let shown = 0;
    for (const figure of figures) {
      const own = figure.dataset;
      figure.hidden = own.view !== view || own.test !== test || (axis !== "all" && own.axis !== axis);
      shown += !figure.hidden;
    }
    for (const group of groups) {
      group.hidden = group.dataset.group !== view;
      group.querySelector(".panels").classList.toggle("one", shown === 1);
    }
    none.hidden = shown > 0;
  }

  form.addEventListener("change", pick);
  form.addEventListener("submit", (event) => event.preventDefault());
  addEventListener("beforeprint", () => {
    for (const fold of document.querySelectorAll("details")) fold.open = true;
  });
  form.hidden = false;
  pick();
})();
