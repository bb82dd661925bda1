// What-if answers by width, and the active lanes of a line of the source.
"use strict";
(function () {
  const kinds = warpgrain.kinds, draw = warpgrain.draw, number = warpgrain.number, short = warpgrain.short, escaped = warpgrain.escaped;
  kinds.what_if = function (element, data) {
    const names = Array.from(new Set(data.points.map(function (p) { return p.series; })));
    draw(element, [["series", "width", "SIMT efficiency", "warp instructions"]].concat(data.points.map(function (p) {
      return [p.series, p.width, p.efficiency, p.instructions];
    })), {
      xAxis: { type: "category", data: data.widths.map(String), name: "warp width" },
      yAxis: { type: "value", name: "SIMT efficiency", min: 0, max: 1, nameGap: 45 },
      tooltip: { trigger: "item", formatter: function (p) {
        return escaped(p.seriesName) + "<br/>" + p.name + " lanes: " + number(p.value[1]) + "<br/>" + number(p.value[2]) + " warp instructions";
      } },
      series: names.map(function (name) {
        return { name: name, type: "line", symbol: "circle", symbolSize: name === "the run" ? 14 : 8, data: data.points.filter(function (p) {
          return p.series === name;
        }).map(function (p) { return [String(p.width), p.efficiency, p.instructions]; }) };
      })
    });
  };

  // The active lanes of the line that is clicked, below it; a second click takes them away.
  const show_lanes = function (row, histogram) {
    const next = row.nextElementSibling;
    if (next ? next.classList.contains("lanes") : false) return next.remove();
    const opened = document.createElement("tr");
    opened.className = "lanes";
    const cell = opened.insertCell();
    cell.colSpan = row.cells.length;
    const element = document.createElement("div");
    element.className = "chart small";
    cell.append(element);
    row.after(opened);
    const all = histogram.reduce(function (a, b) { return a + b; }, 0);
    draw(element, [["active lanes", "executions"]].concat(histogram.map(function (n, k) { return [k, n]; })), {
      xAxis: { type: "category", data: histogram.map(function (n, k) { return k; }), name: "active lanes" },
      yAxis: { type: "value" }, legend: { show: false },
      tooltip: { trigger: "item", formatter: function (p) {
        return p.name + " active lanes: " + number(p.value) + ", " + (100 * p.value / all).toFixed(1) + " %";
      } },
      series: [{ type: "bar", data: histogram, barCategoryGap: "20%" }]
    });
  };
  document.querySelectorAll("svg.lanes[data-lanes]").forEach(function (drawing) {
    const row = drawing.closest("tr");
    row.classList.add("opens");
    row.addEventListener("click", function () { show_lanes(row, drawing.dataset.lanes.split(",").map(Number)); });
  });
})();
