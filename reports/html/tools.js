// What the scripts of a page share: its colours, numbers as people read them, and files to save.
"use strict";
const warpgrain = (function () {
  const style = getComputedStyle(document.documentElement);
  const colour = function (name) { return style.getPropertyValue(name).trim(); };
  const shades = {
    ink: colour("--ink"), soft: colour("--soft"), rule: colour("--rule"), panel: colour("--panel"), paper: colour("--paper"),
    bar: colour("--bar"), hot: "rgb(" + colour("--heat").split(" ").join(",") + ")"
  };
  const palette = [shades.bar, shades.hot, "#4f9d5d", "#b58a2f", "#8d6cc0", "#3aa6a6", "#c0578a", "#7a828c"];

  const number = function (value) {
    if (value === null || value === undefined) return "-";
    const rounded = Number(value.toPrecision(4));
    return Math.abs(value) < 1 ? String(rounded) : rounded.toLocaleString("en");
  };
  const short = function (value) {
    const size = Math.abs(value);
    if (size === 0) return "0";
    return size >= 0.001 && size < 1e6 ? number(value) : value.toExponential(1).replace(".0e", "e").replace("e+", "e");
  };
  const escaped = function (text) {
    const node = document.createElement("span");
    node.textContent = text;
    return node.innerHTML;
  };
  const save_url = function (name, url) {
    const link = document.createElement("a");
    link.href = url;
    link.download = name;
    link.click();
  };
  const save = function (name, type, text) { save_url(name, URL.createObjectURL(new Blob([text], { type: type }))); };
  const quoted = function (cell) { return "\"" + String(cell === null ? "" : cell).split("\"").join("\"\"") + "\""; };
  // `rows`, the first with headings.
  const save_table = function (name, rows) {
    save(name + ".csv", "text/csv", rows.map(function (row) { return row.map(quoted).join(","); }).join("\n") + "\n");
  };
  const button = function (text, action) {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = text;
    made.addEventListener("click", action);
    return made;
  };
  // A canvas as wide as its element, sharp on any screen; `height` in CSS pixels.
  const sharp = function (canvas, width, height) {
    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    canvas.style.width = width + "px";
    canvas.style.height = height + "px";
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    return context;
  };
  const save_canvas = function (name, canvas) { save_url(name + ".png", canvas.toDataURL("image/png")); };
  return { shades: shades, palette: palette, number: number, short: short, escaped: escaped, save: save, save_url: save_url,
           save_table: save_table, save_canvas: save_canvas, button: button, sharp: sharp };
})();
