// Points and lines over two axes, and bars; with intervals where there are some.
"use strict";
(function () {
  const kinds = warpgrain.kinds, draw = warpgrain.draw, number = warpgrain.number, short = warpgrain.short, escaped = warpgrain.escaped;
  const shades = warpgrain.shades;

  const extent = function (values) { return [Math.min.apply(null, values), Math.max.apply(null, values)]; };
  const axis_of = function (name, values, gap) {
    const [low, high] = extent(values);
    const log = low > 0 && high > 20 * low;
    return { type: log ? "log" : "value", scale: true, name: name, nameGap: gap, axisLabel: { color: shades.soft, formatter: short, hideOverlap: true } };
  };
  // A line from low to high behind each point that has both.
  const intervals = function (name, points, colour, horizontal) {
    return { type: "custom", name: name, silent: true, itemStyle: { color: colour }, z: 1, data: points,
      renderItem: function (params, api) {
        const a = horizontal ? api.coord([api.value(0), api.value(2)]) : api.coord([api.value(0), api.value(1)]);
        const b = horizontal ? api.coord([api.value(1), api.value(2)]) : api.coord([api.value(0), api.value(2)]);
        return { type: "line", shape: { x1: a[0], y1: a[1], x2: b[0], y2: b[1] }, style: { stroke: colour, lineWidth: 2, opacity: 0.6 } };
      } };
  };

  kinds.xy = function (element, data) {
    const all = data.series.flatMap(function (s) { return s.points; });
    const xs = all.map(function (p) { return p.x; }), ys = all.map(function (p) { return p.y; });
    const series = data.series.map(function (s, k) {
      const colour = warpgrain.palette[k % warpgrain.palette.length];
      return { type: s.line ? "line" : "scatter", name: s.name, symbolSize: s.line ? 7 : 10, symbol: s.hollow ? "emptyCircle" : "circle",
        itemStyle: { color: colour, opacity: 0.9 }, lineStyle: { color: colour, width: 2 },
        data: s.points.map(function (p) { return { name: p.label || "", value: [p.x, p.y] }; }) };
    });
    data.series.forEach(function (s, k) {
      const points = s.points.filter(function (p) { return p.low !== undefined; });
      if (points.length) series.push(intervals(s.name, points.map(function (p) { return [p.x, p.low, p.high]; }),
                                               warpgrain.palette[k % warpgrain.palette.length], false));
    });
    const x = axis_of(data.x, xs, 30), y = axis_of(data.y, ys, 54);
    if (data.from_zero && y.type === "value") Object.assign(y, { scale: false, min: 0 });
    if (data.diagonal) {
      const [low, high] = extent(xs.concat(ys));
      // The ends are no round numbers.
      [x, y].forEach(function (axis) {
        Object.assign(axis, { min: low / 1.2, max: high * 1.2, type: x.type });
        Object.assign(axis.axisLabel, { showMinLabel: false, showMaxLabel: false });
      });
      series.push({ type: "line", name: "equal", data: [[low / 1.2, low / 1.2], [high * 1.2, high * 1.2]], symbol: "none", silent: true,
                    lineStyle: { color: shades.soft, type: "dashed", width: 1 } });
    }
    draw(element, [["series", "name", data.x, data.y, "low", "high"]].concat(data.series.flatMap(function (s) {
      return s.points.map(function (p) { return [s.name, p.label || "", p.x, p.y, p.low === undefined ? "" : p.low, p.high === undefined ? "" : p.high]; });
    })), {
      xAxis: x, yAxis: y, legend: { show: data.series.length > 1, data: data.series.map(function (s) { return s.name; }),
                                    textStyle: { color: shades.soft }, type: "scroll", top: 0, left: 0, right: 0 },
      tooltip: { trigger: "item", confine: true, formatter: function (p) {
        return "<b>" + escaped(p.name || p.seriesName) + "</b><br/>" + escaped(data.x) + " " + number(p.value[0]) + "<br/>" + escaped(data.y) + " " + number(p.value[1]);
      } },
      series: series
    });
  };

  // A bar a row, from the top, its text to the left; on a logarithmic axis, which has no origin, a point.
  kinds.bars = function (element, data) {
    const longest = Math.max.apply(null, data.names.map(function (name) { return name.length; }));
    element.style.height = Math.max(140, 90 + data.names.length * (8 + 14 * data.series.length)) + "px";
    draw(element, [["name"].concat(data.series.map(function (s) { return s.name; }))].concat(data.names.map(function (name, k) {
      return [name].concat(data.series.map(function (s) { return s.values[k]; }));
    })), {
      grid: { left: Math.min(360, 20 + 6.4 * longest), right: 40, top: data.series.length > 1 ? 36 : 12, bottom: 46 },
      xAxis: { type: data.log ? "log" : "value", scale: data.log, name: data.value, axisLabel: { color: shades.soft, formatter: short, hideOverlap: true } },
      yAxis: { type: "category", inverse: true, data: data.names, splitLine: { show: false },
               axisLabel: { color: shades.ink, width: 340, overflow: "truncate", interval: 0 } },
      // A series keeps its colour from chart to chart, and has no entry where it has no value.
      legend: { show: data.series.length > 1, textStyle: { color: shades.soft }, type: "scroll", top: 0, left: 0, right: 0,
                data: data.series.filter(function (s) { return s.values.some(function (v) { return v !== null; }); }).map(function (s) { return s.name; }) },
      tooltip: { trigger: "item", confine: true, formatter: function (p) {
        return "<b>" + escaped(p.name) + "</b><br/>" + (data.series.length > 1 ? escaped(p.seriesName) + " " : "") + number(data.log ? p.value[0] : p.value) + " " + escaped(data.value);
      } },
      series: data.series.map(function (s) {
        if (!data.log) return { type: "bar", name: s.name, data: s.values, barMaxWidth: 14 };
        return { type: "scatter", name: s.name, symbolSize: 12, data: s.values.map(function (v, k) { return [v === null ? "-" : v, data.names[k]]; }) };
      })
    });
  };

  // A mean a row, with its interval, and the reference's mean as a line.
  kinds.intervals = function (element, data) {
    const points = data.points, longest = Math.max.apply(null, points.map(function (p) { return p.name.length; }));
    element.style.height = 100 + 22 * points.length + "px";
    const colour = function (p) { return p.marked ? shades.hot : shades.bar; };
    const series = [{ type: "scatter", symbolSize: 9, data: points.map(function (p) {
      return { name: p.name, value: [p.mean, p.name], itemStyle: { color: colour(p) } };
    }) }];
    points.forEach(function (p, k) { series.push(intervals(p.name, [[p.low, p.high, k]], colour(p), true)); });
    if (data.reference !== null)
      series[0].markLine = { silent: true, symbol: "none", label: { show: false }, lineStyle: { color: shades.soft, type: "dashed" }, data: [{ xAxis: data.reference }] };
    const ends = points.map(function (p) { return p.low; }).concat(points.map(function (p) { return p.high; }));
    const low = Math.min.apply(null, ends), high = Math.max.apply(null, ends), margin = 0.05 * (high - low) || 0.05 * Math.abs(high) || 1;
    draw(element, [["name", "mean", "low", "high", "significant"]].concat(points.map(function (p) { return [p.name, p.mean, p.low, p.high, p.marked]; })), {
      grid: { left: Math.min(360, 20 + 6.4 * longest), right: 40, top: 12, bottom: 46 }, legend: { show: false },
      xAxis: { type: "value", name: data.value, min: low - margin, max: high + margin,
               axisLabel: { color: shades.soft, formatter: short, hideOverlap: true, showMinLabel: false, showMaxLabel: false } },
      yAxis: { type: "category", inverse: true, data: points.map(function (p) { return p.name; }), splitLine: { show: false },
               axisLabel: { color: shades.ink, width: 340, overflow: "truncate", interval: 0 } },
      tooltip: { trigger: "item", confine: true, formatter: function (p) {
        const point = points[p.dataIndex];
        return "<b>" + escaped(point.name) + "</b><br/>" + number(point.mean) + ", " + number(point.low) + " to " + number(point.high);
      } },
      series: series
    });
  };

  // Two bars a kernel, of the metric that is picked.
  kinds.differences = function (element, data) {
    const metrics = Array.from(new Set(data.rows.map(function (row) { return row.metric; })));
    const first = ["seconds", "warp_instructions"].find(function (name) { return metrics.includes(name); }) || metrics[0];
    const choice = document.createElement("select");
    choice.setAttribute("aria-label", "metric");
    metrics.forEach(function (name) { choice.add(new Option(name, name, false, name === first)); });
    const bar = document.createElement("p");
    bar.append(choice);
    element.before(bar);
    const update = function () {
      const rows = data.rows.filter(function (row) { return row.metric === choice.value; });
      kinds.bars(element, { names: rows.map(function (row) { return row.kernel; }), value: choice.value, series: [
        { name: data.base, values: rows.map(function (row) { return row.base; }) },
        { name: data.other, values: rows.map(function (row) { return row.other; }) }] });
    };
    choice.addEventListener("change", update);
    update();
  };
})();
