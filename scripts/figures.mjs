#!/usr/bin/env node
// Draws the figures of docs/accuracy.md and docs/stability.md from what the commands write as JSON, one SVG each.
//
//   build/release/cli/warpgrain accuracy --study impacts --quiet --json impacts.json
//   scripts/figures.mjs docs/figures impacts.json ...
//
// Takes documents of `accuracy` and `stability`; which figures follow, their formats say. Needs ECharts, which
// scripts/install_dependencies.sh puts into reports/html. Text takes the colour that the reader's light or dark
// page asks for.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";

const require = createRequire(new URL("../reports/html/package.json", import.meta.url));
const echarts = require("echarts");

const INK = "#0a0b0c"; // stands for the text's colour until the SVG is written
const FAINT = "#8888887f";
const SERIES = ["#3b82c4", "#d9822b", "#2e9e6b", "#b5509c", "#8a7a2f"];
const STYLE = "<style>svg{color:#1f2328}@media(prefers-color-scheme:dark){svg{color:#e6edf3}}</style>";

function write(folder, name, width, height, option) {
  const chart = echarts.init(null, null, { renderer: "svg", ssr: true, width, height });
  chart.setOption({ animation: false, backgroundColor: "transparent", color: SERIES, textStyle: { color: INK }, ...option });
  const svg = chart.renderToSVGString().replaceAll(INK, "currentColor").replaceAll(`fill="#fff"`, `fill="none"`).replace(/(<svg[^>]*>)/, `$1${STYLE}`);
  chart.dispose();
  writeFileSync(`${folder}/${name}.svg`, svg + "\n");
}

const axis = (name, more = {}) => ({
  type: "value", name, nameLocation: "middle", nameGap: 30, nameTextStyle: { color: INK },
  axisLabel: { color: INK }, axisLine: { show: true, lineStyle: { color: FAINT } }, splitLine: { lineStyle: { color: FAINT, width: 0.5 } },
  ...more,
});

const title = (text, left, top) => ({ text, left, top, textAlign: "center", textStyle: { color: INK, fontSize: 13, fontWeight: "normal" } });

// Panels side by side, each { title, x, y, series: [{ name, data, marks }] }.
function panels(folder, name, columns, list, legend) {
  const width = 320, height = 290, rows = Math.ceil(list.length / columns);
  const option = { title: [], grid: [], xAxis: [], yAxis: [], series: [], legend: { data: legend, bottom: 0, itemGap: 30, textStyle: { color: INK } } };
  list.forEach((panel, k) => {
    const left = (k % columns) * width, top = Math.floor(k / columns) * height;
    option.title.push(title(panel.title, left + 60 + 120, top + 4));
    option.grid.push({ left: left + 66, top: top + 32, width: width - 92, height: height - 90 });
    option.xAxis.push({ ...axis(panel.x), gridIndex: k, ...panel.xAxis });
    option.yAxis.push({ ...axis(panel.y), nameGap: 44, gridIndex: k, ...panel.yAxis });
    for (const series of panel.series)
      option.series.push({
        type: series.marks ? "scatter" : "line", name: series.name, data: series.data, xAxisIndex: k, yAxisIndex: k,
        color: SERIES[legend.indexOf(series.name) % SERIES.length], symbolSize: series.marks === "emptyDiamond" ? 13 : 6, showSymbol: Boolean(series.marks), smooth: !series.marks && !panel.straight, lineStyle: { width: 2 },
        symbol: series.marks ?? "circle", itemStyle: series.marks ? { opacity: 0.8 } : {},
      });
  });
  write(folder, name, columns * width, rows * height + 30, option);
}

const table = (study, words) => study.tables.find((t) => words.every((w) => t.title.includes(w)));
const column = (t, k) => t.rows.map((row) => [row[0], row[k]]);

function drawImpacts(folder, study) {
  const variant = study.tables[0].rows.find((row) => row[1] !== "Hertz" && row[1] !== "double reference")[1];
  const marks = { "double reference": "emptyDiamond", [variant]: "circle" };
  const forces = study.tables.filter((t) => t.title.includes("normal force")).map((t) => ({
    title: t.title.replace(": normal force [kN] over time,", ","), x: "time [us]", y: "normal force [kN]",
    series: t.columns.slice(1).map((by, k) => ({ name: by, data: column(t, k + 1), marks: marks[by] })),
  }));
  panels(folder, "impact_force", 2, forces, ["Hertz", "double reference", variant]);

  const restitution = table(study, ["Test 3"]);
  const scenes = [...new Set(restitution.rows.map((row) => row[0]))];
  panels(folder, "impact_restitution", 2, scenes.map((scene) => ({
    title: `Test 3, ${scene}`, x: "restitution set", y: "restitution seen",
    series: [{ name: "as set", data: [[0.2, 0.2], [1, 1]] }, ...restitution.columns.slice(2).map((by, k) => ({
      name: by, marks: marks[by], data: restitution.rows.filter((row) => row[0] === scene).map((row) => [row[1], row[k + 2]]),
    }))],
  })), ["as set", "double reference", variant]);

  const oblique = study.tables.filter((t) => t.title.includes("Test 4"));
  panels(folder, "impact_oblique", 3, oblique.flatMap((t) => [2, 3, 4].map((k) => ({
    title: t.title.replace(": oblique impact,", ","), x: "angle [degrees]", y: t.columns[k], xAxis: { max: 90 },
    series: ["theory", "double reference", variant].map((by) => ({
      name: by, marks: marks[by], data: t.rows.filter((row) => row[1] === by).map((row) => [row[0], row[k]]),
    })),
  }))), ["theory", "double reference", variant]);
}

function drawConvergence(folder, study) {
  panels(folder, "convergence", 3, study.tables.map((t) => {
    const steps = t.columns.slice(1, -2).map(Number), finest = t.columns.length - 2;
    const [, angle, restitution] = t.title.match(/at ([\d.]+) degrees with restitution ([\d.]+)/);
    return {
      title: `${angle} degrees, restitution ${restitution}`, x: "steps a contact", y: "spin off by [rad/s]", straight: true,
      xAxis: { type: "log", min: 20, max: 2000, axisLabel: { color: INK, showMaxLabel: false } },
      yAxis: { type: "log", min: 1e-4, max: 1e3, axisLabel: { color: INK, formatter: (v) => v.toExponential(0) } },
      series: t.rows.map((row) => ({
        name: row[0], data: steps.map((n, k) => [n, Math.max(1e-4, Math.abs(row[k + 1] - row[finest]))]),
      })),
    };
  }), table(study, ["Spin"]).rows.map((row) => row[0]));
}

const COSTS = { warp_instructions: "warp instructions", bytes: "bytes", seconds: "time", predicted_seconds: "predicted time", measured_seconds: "measured time" };

// Points that lie on each other are one, with the first's name and how many more.
function named(points) {
  const seen = [], widest = Math.max(...points.map((p) => p.x));
  for (const point of points) {
    const near = seen.find((p) => Math.abs(p.x - point.x) < 0.035 * widest && Math.abs(Math.log10(p.y / point.y)) < 0.15 && p.front === point.front);
    if (near) near.more += 1;
    else seen.push({ ...point, more: 0 });
  }
  return seen;
}

function drawFront(folder, report, name) {
  const short = (row) => {
    const usual = ["branchy", "cells", "cell", "fp32", "default"];
    const rest = row.variant.split("/").filter((word, k) => word !== usual[k]);
    return (rest.join("/") || "default variant") + (row.step_factor === 1 ? "" : `, ${row.step_factor} x step`);
  };
  const criteria = [["rms error of a force", (row) => row.force?.root_mean_square],
    ["error of restitution and spin", (row) => row.collision && Math.max(row.collision.restitution, row.collision.spin)]];
  const option = { title: [], grid: [], xAxis: [], yAxis: [], series: [], legend: { data: ["on the front", "dominated"], bottom: 0, itemGap: 30, textStyle: { color: INK } } };
  criteria.forEach(([what, error], k) => {
    const points = named(report.cases.filter((row) => row.relative_cost > 0 && error(row) > 0)
      .map((row) => ({ x: row.relative_cost, y: error(row), front: row.on_front, label: short(row) })));
    option.grid.push({ left: 80 + k * 510, top: 90, width: 370, height: 330 });
    option.xAxis.push({ ...axis(`cost: ${COSTS[report.cost]}, for the same time simulated`), min: 0, gridIndex: k });
    option.yAxis.push({ ...axis(what), type: "log", gridIndex: k, nameGap: 52, axisLabel: { color: INK, formatter: (v) => v.toExponential(0) } });
    for (const front of [true, false])
      option.series.push({
        type: "scatter", name: front ? "on the front" : "dominated", xAxisIndex: k, yAxisIndex: k, symbolSize: 9,
        symbol: front ? "circle" : "emptyCircle", color: front ? SERIES[0] : SERIES[1],
        data: points.filter((p) => p.front === front).map((p) => ({ value: [p.x, p.y], name: p.more ? `${p.label} +${p.more}` : p.label })),
        label: { show: true, formatter: "{b}", position: [6, -2], rotate: 50, align: "left", verticalAlign: "bottom", color: INK, fontSize: 10 },
      });
  });
  write(folder, name, 1040, 500, option);
}

function shareOfRange(probe, cell) {
  if (cell.right_beyond === undefined) return 1;
  if (cell.right_until === undefined) return 0;
  return Math.log(cell.right_until / probe.from) / Math.log(probe.to / probe.from);
}

const number = (x) => (x >= 0.01 && x < 1000 ? String(+x.toPrecision(2)) : x.toExponential(0).replace("e+", "e"));

function drawAtlas(folder, report, name) {
  const hosts = new Set(report.cells.map((cell) => cell.backend)).size > 1;
  const column = (cell) => cell.variant + (hosts ? ` (${cell.backend})` : "");
  const variants = [...new Set(report.cells.map(column))], probes = report.probes.map((probe) => probe.name);
  const data = report.cells.map((cell) => {
    const probe = report.probes.find((p) => p.name === cell.probe);
    const at = [variants.indexOf(column(cell)), probes.length - 1 - probes.indexOf(cell.probe)];
    if (cell.verdict === "not_applicable") return { value: [...at, "-"], text: "" };
    const share = shareOfRange(probe, cell);
    const limit = cell.right_until === undefined ? "nowhere" : number(cell.right_until);
    return { value: [...at, share], text: share === 1 ? "" : limit + (cell.verdict === "refused" ? "!" : "") };
  });
  const wide = 52, high = 22, left = 260, top = 262;
  const category = (names, more) => ({ type: "category", data: names, axisTick: { show: false }, axisLine: { show: false }, ...more });
  write(folder, name, left + variants.length * wide + 40, top + probes.length * high + 50, {
    grid: { left, top, width: variants.length * wide, height: probes.length * high },
    xAxis: category(variants, { position: "top", axisLabel: { color: INK, rotate: 60, interval: 0, fontSize: 11 } }),
    yAxis: category(report.probes.map((probe) => probe.name + (probe.unit ? ` [${probe.unit}]` : "")).reverse(),
      { axisLabel: { color: INK, interval: 0, fontSize: 11 } }),
    visualMap: {
      min: 0, max: 1, orient: "horizontal", left, bottom: 8, itemWidth: 14, itemHeight: 160, calculable: false,
      text: ["all of the range is right", "nothing is"], textStyle: { color: INK },
      inRange: { color: ["#b8442f", "#d98f4e", "#e8cf7d", "#7fb88f", "#2f7f79"] },
    },
    series: [{
      type: "heatmap", data, itemStyle: { borderColor: "#8888885f", borderWidth: 1 },
      label: { show: true, formatter: (p) => p.data.text, color: "#101418", fontSize: 10 },
    }],
  });
}

const [folder, ...files] = process.argv.slice(2);
if (!files.length) {
  console.error("usage: scripts/figures.mjs FOLDER DOCUMENT.json...");
  process.exit(2);
}
mkdirSync(folder, { recursive: true });
for (const file of files) {
  const document = JSON.parse(readFileSync(file, "utf8"));
  const name = file.replace(/^.*\//, "").replace(/\.json$/, "");
  if (document.format === "warpgrain.study/1" && document.study === "impacts") drawImpacts(folder, document);
  else if (document.format === "warpgrain.study/1") drawConvergence(folder, document);
  else if (document.format === "warpgrain.accuracy/1") drawFront(folder, document, name);
  else if (document.format === "warpgrain.stability/1") drawAtlas(folder, document, name);
  else {
    console.error(`${file}: ${document.format} has no figure`);
    process.exit(2);
  }
}
