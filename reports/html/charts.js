// Draws every div.chart by its kind, and the active lanes of whatever small drawing is clicked. Colours follow the page's.
"use strict";
(function () {
  const style = getComputedStyle(document.documentElement);
  const colour = function (name) { return style.getPropertyValue(name).trim(); };
  const ink = colour("--ink"), soft = colour("--soft"), rule = colour("--rule"), bar = colour("--bar");
  const hot = "rgb(" + colour("--heat").split(" ").join(",") + ")";
  const palette = [bar, hot, "#4f9d5d", "#b58a2f", "#8d6cc0", "#3aa6a6", "#c0578a", "#7a828c"];

  const quoted = function (cell) { return "\"" + String(cell).split("\"").join("\"\"") + "\""; };
  const save = function (name, type, text) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type: type }));
    link.download = name;
    link.click();
  };

  // `rows` of the data that is drawn, the first with headings.
  const draw = function (element, rows, option) {
    const chart = echarts.init(element, null, { renderer: "svg" });
    const axis = { axisLine: { lineStyle: { color: rule } }, axisLabel: { color: soft }, nameTextStyle: { color: soft },
                   splitLine: { lineStyle: { color: rule } }, nameLocation: "middle", nameGap: 30 };
    ["xAxis", "yAxis"].forEach(function (key) { if (option[key]) option[key] = Object.assign({}, axis, option[key]); });
    chart.setOption(Object.assign({
      color: palette, animation: false, textStyle: { color: ink }, grid: { left: 70, right: 30, top: 40, bottom: 50 },
      legend: { textStyle: { color: soft }, type: "scroll", top: 0, bottom: "auto", left: 0, right: 90 },
      tooltip: { backgroundColor: colour("--panel"), borderColor: rule, textStyle: { color: ink } },
      toolbox: { iconStyle: { borderColor: soft }, feature: {
        saveAsImage: { title: "as SVG" },
        myTable: { show: true, title: "data as CSV", icon: "path://M2 2h20v20h-20zM2 9h20M2 16h20M9 2v20",
          onclick: function () {
            save("chart.csv", "text/csv", rows.map(function (row) { return row.map(quoted).join(","); }).join("\n") + "\n");
          } } } }
    }, option), true);
    return chart;
  };

  const escaped = function (text) {
    const node = document.createElement("span");
    node.textContent = text;
    return node.innerHTML;
  };
  const number = function (value) {
    return value === null ? "-" : 1 > Math.abs(value) ? String(Number(value.toPrecision(4)))
                                                      : Number(value.toPrecision(4)).toLocaleString("en");
  };
  const short = function (value) {
    const size = Math.abs(value);
    return size === 0 ? "0" : size >= 0.001 ? (1e7 > size ? number(value) : value.toExponential(1)) : value.toExponential(1);
  };
  const transposed = function (headings, columns) {
    return [headings].concat(columns[0].map(function (unused, k) { return columns.map(function (c) { return c[k]; }); }));
  };

  const kinds = {};

  kinds.trade_off = function (element, data) {
    const column = function (pattern, other) {
      const found = data.columns.findIndex(function (c) { return c.name.indexOf(pattern) >= 0; });
      return found >= 0 ? found : other;
    };
    const chosen = { x: column("warp instructions", 0), y: column("max error", data.columns.length - 1) };
    const bar_of_choices = document.createElement("p");
    ["x", "y"].forEach(function (side) {
      const select = document.createElement("select");
      select.setAttribute("aria-label", side + " axis");
      data.columns.forEach(function (c, k) { select.add(new Option(c.name, k, false, k === chosen[side])); });
      select.addEventListener("change", function () { chosen[side] = Number(select.value); update(); });
      bar_of_choices.append(side + ": ", select, " ");
    });
    element.before(bar_of_choices);
    let chart = null;
    const update = function () {
      const x = data.columns[chosen.x], y = data.columns[chosen.y];
      const points = data.names.map(function (name, k) { return { name: name, value: [x.values[k], y.values[k]] }; })
        .filter(function (p) { return p.value[0] !== null ? p.value[1] !== null : false; });
      const better = function (c, a, b) { return c.higher_is_better ? a >= b : b >= a; };
      const best = points.filter(function (p) {
        return !points.some(function (q) {
          return better(x, q.value[0], p.value[0]) ? better(y, q.value[1], p.value[1]) ? q.value[0] !== p.value[0] ||
            q.value[1] !== p.value[1] : false : false;
        });
      }).sort(function (a, b) { return a.value[0] - b.value[0]; });
      const scale = function (c) {
        const known = c.values.filter(function (v) { return v !== null; });
        const low = Math.min.apply(null, known);
        return low > 0 ? (Math.max.apply(null, known) > 8 * low ? "log" : "value") : "value";
      };
      const axis = function (c, gap) { return { type: scale(c), scale: true, name: c.name, nameGap: gap,
        axisLabel: { color: soft, formatter: short } }; };
      if (chart) chart.dispose();
      chart = draw(element, transposed(["variant", x.name, y.name], [data.names, x.values, y.values]), {
        xAxis: axis(x, 30), yAxis: axis(y, 52), legend: { show: false },
        tooltip: { trigger: "item", formatter: function (p) {
          return "<b>" + escaped(p.name) + "</b><br/>" + escaped(x.name) + " " + number(p.value[0]) + "<br/>" + escaped(y.name) + " " + number(p.value[1]);
        } },
        series: [
          { type: "line", data: best, symbol: "none", silent: true, lineStyle: { color: hot, width: 1.5 } },
          { type: "scatter", data: points, symbolSize: 10, itemStyle: { color: bar, opacity: 0.8 } },
          { type: "scatter", data: best, symbolSize: 12, itemStyle: { color: hot } }]
      });
    };
    update();
  };

  kinds.parallel = function (element, data) {
    const several = data.axes.filter(function (a) { return new Set(a.values).size > 1; });
    const columns = several.concat(data.columns);
    const efficiency = data.columns.findIndex(function (c) { return c.name.indexOf("efficiency") >= 0; });
    const axes = columns.map(function (c, k) {
      const axis = { dim: k, name: c.name.split(" ").join("\n"), nameTextStyle: { color: soft, lineHeight: 14, verticalAlign: "bottom" },
                     axisLabel: { color: soft, formatter: function (v) { return typeof v === "number" ? short(v) : v; } },
                     axisLine: { lineStyle: { color: rule } } };
      return several.length > k ? Object.assign(axis, { type: "category", data: Array.from(new Set(c.values)) })
                                : Object.assign(axis, { type: "value", scale: true });
    });
    const values = columns.map(function (c) { return c.values; });
    const rows = transposed(columns.map(function (c) { return c.name; }), values).slice(1).map(function (row, k) {
      return { name: data.names[k], value: row.map(function (v) { return v === null ? "-" : v; }) };
    });
    const option = {
      parallelAxis: axes, parallel: { left: 50, right: 80, top: 90, bottom: 30 }, legend: { show: false },
      tooltip: { trigger: "item", formatter: function (p) { return escaped(p.name); } },
      series: [{ type: "parallel", smooth: false, lineStyle: { width: 1.5, opacity: 0.6, color: bar }, data: rows }]
    };
    if (efficiency >= 0) {
      const known = data.columns[efficiency].values.filter(function (v) { return v !== null; });
      option.visualMap = { show: false, dimension: several.length + efficiency, min: Math.min.apply(null, known),
                           max: Math.max.apply(null, known), inRange: { color: [hot, bar] } };
    }
    draw(element, transposed(["variant"].concat(columns.map(function (c) { return c.name; })), [data.names].concat(values)), option);
  };

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
        return { name: name, type: "line", symbolSize: name === "the run" ? 14 : 8, data: data.points.filter(function (p) {
          return p.series === name;
        }).map(function (p) { return [String(p.width), p.efficiency, p.instructions]; }) };
      })
    });
  };

  document.querySelectorAll("div.chart").forEach(function (element) {
    kinds[element.dataset.kind](element, JSON.parse(element.dataset.chart));
  });

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
  window.addEventListener("resize", function () {
    document.querySelectorAll("div.chart").forEach(function (element) { echarts.getInstanceByDom(element).resize(); });
  });
})();
