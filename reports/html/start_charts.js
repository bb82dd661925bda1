// Draws every div.chart by its kind.
"use strict";
document.querySelectorAll("div.chart[data-kind]").forEach(function (element) {
  warpgrain.kinds[element.dataset.kind](element, JSON.parse(element.dataset.chart));
});
(function () {
  const fit = function () {
    document.querySelectorAll("div.chart").forEach(function (element) {
      const chart = echarts.getInstanceByDom(element);
      if (chart) chart.resize();
    });
  };
  window.addEventListener("resize", fit);
  // What was drawn in a closed section had no width.
  document.querySelectorAll("details").forEach(function (section) { section.addEventListener("toggle", fit); });
})();
