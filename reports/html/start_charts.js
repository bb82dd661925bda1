"use strict";
// Charts come one after the other behind the page's load, so that a table of hundreds of variants can be read at once; before
// printing all that are left.
(function () {
  const left = Array.from(document.querySelectorAll("div.chart[data-kind]"));
  const draw_next = function () {
    const element = left.shift();
    warpgrain.kinds[element.dataset.kind](element, JSON.parse(element.dataset.chart));
  };
  const go_on = function () {
    if (left.length === 0) return;
    draw_next();
    setTimeout(go_on, 0);
  };
  warpgrain.draw_charts = function () { while (left.length > 0) draw_next(); };
  window.addEventListener("load", function () { setTimeout(go_on, 0); });
  window.addEventListener("beforeprint", warpgrain.draw_charts);
})();
(function () {
  const fit = function () {
    document.querySelectorAll("div.chart").forEach(function (element) {
      const chart = warpgrain.chart_in(element);
      if (chart) chart.resize();
    });
  };
  window.addEventListener("resize", fit);
  // What was drawn in a closed section had no width.
  document.querySelectorAll("details").forEach(function (section) { section.addEventListener("toggle", fit); });
})();
