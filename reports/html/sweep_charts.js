// One column against another, and all of them side by side.
"use strict";
(function () {
  const kinds = warpgrain.kinds, draw = warpgrain.draw, number = warpgrain.number, short = warpgrain.short, escaped = warpgrain.escaped;
  const shades = warpgrain.shades, soft = shades.soft, rule = shades.rule, bar = shades.bar, hot = shades.hot;
  const transposed = function (headings, columns) {
    return [headings].concat(columns[0].map(function (unused, k) { return columns.map(function (c) { return c[k]; }); }));
  };

  kinds.trade_off = function (element, data) {
    const column = function (pattern, other) {
      const found = data.columns.findIndex(function (c) { return c.name.indexOf(pattern) >= 0; });
      return found >= 0 ? found : other;
    };
    const chosen = { x: column(data.x || "warp instructions", 0), y: column(data.y || "max error", data.columns.length - 1) };
    const bar_of_choices = document.createElement("p");
    bar_of_choices.className = "controls";
    ["x", "y"].forEach(function (side) {
      const select = document.createElement("select");
      select.setAttribute("aria-label", side + " axis");
      data.columns.forEach(function (c, k) { select.add(new Option(c.name, k, false, k === chosen[side])); });
      select.addEventListener("change", function () { chosen[side] = Number(select.value); update(); });
      bar_of_choices.append(side + ": ", select, " ");
    });
    element.before(bar_of_choices);
    const update = function () {
      const x = data.columns[chosen.x], y = data.columns[chosen.y];
      const points = data.names.map(function (name, k) {
        const hollow = data.beaten ? data.beaten[k] : false;
        return { name: name, value: [x.values[k], y.values[k]], symbol: hollow ? "emptyCircle" : "circle" };
      })
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
      draw(element, transposed(["variant", x.name, y.name], [data.names, x.values, y.values]), {
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
    // Active lanes are the efficiency once more.
    const numbers = data.columns.filter(function (c) { return c.name !== "active lanes"; });
    const columns = several.concat(numbers);
    const efficiency = numbers.findIndex(function (c) { return c.name.indexOf("efficiency") >= 0; });
    const axes = columns.map(function (c, k) {
      const axis = { dim: k, name: c.name.split(/[ _]/).join("\n"), nameTextStyle: { color: shades.ink, lineHeight: 14, verticalAlign: "bottom" },
                     axisLabel: { color: shades.ink, textBorderColor: shades.paper, textBorderWidth: 3, formatter: function (v) { return typeof v === "number" ? short(v) : v; } },
                     axisLine: { lineStyle: { color: rule } } };
      return several.length > k ? Object.assign(axis, { type: "category", data: Array.from(new Set(c.values)) })
                                : Object.assign(axis, { type: "value", scale: true });
    });
    const values = columns.map(function (c) { return c.values; });
    const rows = transposed(columns.map(function (c) { return c.name; }), values).slice(1).map(function (row, k) {
      return { name: data.names[k], value: row.map(function (v) { return v === null ? "-" : v; }) };
    });
    element.style.minWidth = 96 * columns.length + "px";
    const option = {
      parallelAxis: axes, parallel: { left: 50, right: 90, top: 90, bottom: 30 }, legend: { show: false },
      tooltip: { trigger: "item", formatter: function (p) { return escaped(p.name); } },
      series: [{ type: "parallel", smooth: false, lineStyle: { width: 1.5, opacity: 0.6, color: bar }, data: rows }]
    };
    if (efficiency >= 0) {
      const known = numbers[efficiency].values.filter(function (v) { return v !== null; });
      option.visualMap = { show: false, dimension: several.length + efficiency, min: Math.min.apply(null, known),
                           max: Math.max.apply(null, known), inRange: { color: [hot, bar] } };
    }
    draw(element, transposed(["variant"].concat(columns.map(function (c) { return c.name; })), [data.names].concat(values)), option);
  };
})();
