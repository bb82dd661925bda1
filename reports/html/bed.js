// div.bed: the particles, seen from where the reader turns them; what lies before the cut is left away. A click marks the
// particles of a warp.
"use strict";
document.querySelectorAll("div.bed").forEach(function (element) {
  const bed = JSON.parse(element.dataset.bed), n = bed.x.length;
  const height = 520, n_shades = 24, shades = warpgrain.shades;
  // Viridis, which orders by lightness on light and dark paper.
  const stops = [[68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142], [31, 158, 137], [53, 183, 121],
                 [110, 206, 88], [181, 222, 43], [253, 231, 37]];
  const shade = function (share, factor) {
    const at = Math.min(stops.length - 1.001, Math.max(0, share) * (stops.length - 1)), k = Math.floor(at), rest = at - k;
    return "rgb(" + stops[k].map(function (c, i) { return Math.round(factor * (c + rest * (stops[k + 1][i] - c))); }).join(",") + ")";
  };
  const values = { contacts: { label: "contacts (coordination number)", of: bed.contacts },
                   candidates: { label: "candidates in the 27 cells", of: bed.candidates } };
  if (bed.kernel) values.efficiency = { label: "SIMT efficiency of its warp", of: bed.efficiency };
  const radius = function (k) { return bed.radius.length === 1 ? bed.radius[0] : bed.radius[k]; };
  const low = bed.box[0], high = bed.box[1];
  const middle = [0, 1, 2].map(function (d) { return (low[d] + high[d]) / 2; });
  const diagonal = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  const places = [bed.x, bed.y, bed.z];

  let chosen = values[bed.kernel ? "efficiency" : "contacts"], axis = 1, cut = 0, yaw = 0.5, pitch = 0.35, marked = -1;
  let drawn = [];  // {k, x, y, r}, from the back to the front

  const colour_choice = document.createElement("select");
  colour_choice.setAttribute("aria-label", "colour");
  ["efficiency", "contacts", "candidates"].forEach(function (key) {
    if (values[key]) colour_choice.add(new Option("colour: " + values[key].label, key));
  });
  const axis_choice = document.createElement("select");
  axis_choice.setAttribute("aria-label", "cut along");
  ["x", "y", "z"].forEach(function (name, d) { axis_choice.add(new Option("cut along " + name, d, false, d === axis)); });
  const slice = document.createElement("input");
  Object.assign(slice, { type: "range", min: "0", max: "100", value: "0" });
  slice.setAttribute("aria-label", "how much is cut away");
  const cut_at = document.createElement("span");
  cut_at.className = "soft";
  const canvas = document.createElement("canvas"), readout = document.createElement("p"), legend = document.createElement("p");
  readout.className = "readout";
  legend.className = "legend";
  const controls = document.createElement("p");
  controls.className = "controls";
  controls.append(colour_choice, " ", axis_choice, " ", slice, " ", cut_at, " ",
                  warpgrain.button("PNG", function () { warpgrain.save_canvas("bed", canvas); }),
                  warpgrain.button("CSV", function () { warpgrain.save_table("bed", table()); }));
  element.append(controls, legend, canvas, readout);

  const table = function () {
    const rows = [["x [m]", "y [m]", "z [m]", "radius [m]", "contacts", "candidates"].concat(bed.kernel ? ["warp", "SIMT efficiency"] : [])];
    for (let k = 0; k < n; ++k)
      rows.push(places.map(function (p) { return p[k] * bed.unit; }).concat([radius(k) * bed.unit, bed.contacts[k], bed.candidates[k]],
                                                                            bed.kernel ? [bed.warp[k], bed.efficiency[k]] : []));
    return rows;
  };
  const range = function () {
    let least = Infinity, most = -Infinity;
    chosen.of.forEach(function (v) { least = Math.min(least, v); most = Math.max(most, v); });
    return [least, most > least ? most : least + 1];
  };

  // A disc of each shade, lit from above; drawn once, then stamped.
  let stamps = [];
  const make_stamps = function (size) {
    const stamp = function (share, factor) {
      const disc = document.createElement("canvas");
      disc.width = disc.height = Math.max(2, Math.ceil(2 * size));
      const context = disc.getContext("2d"), r = disc.width / 2;
      const light = context.createRadialGradient(0.75 * r, 0.7 * r, 0.1 * r, r, r, r);
      light.addColorStop(0, share < 0 ? shades.rule : shade(share, factor));
      light.addColorStop(1, share < 0 ? shades.rule : shade(share, 0.62 * factor));
      context.fillStyle = light;
      context.beginPath();
      context.arc(r, r, r, 0, 2 * Math.PI);
      context.fill();
      return disc;
    };
    stamps = [];
    for (let s = 0; s < n_shades; ++s) stamps.push(stamp(s / (n_shades - 1), 1));
    stamps.push(stamp(-1, 1));  // what is not marked
  };

  const draw = function () {
    const width = Math.max(100, element.clientWidth), context = warpgrain.sharp(canvas, width, height);
    const scale = 0.92 * Math.min(width, height * 1.25) / diagonal;
    const cy = Math.cos(yaw), sy = Math.sin(yaw), cp = Math.cos(pitch), sp = Math.sin(pitch);
    const bound = low[axis] + cut / 100 * (high[axis] - low[axis]);
    const project = function (x, y, z) {
      const dx = x - middle[0], dy = y - middle[1], dz = z - middle[2], away = sy * dx + cy * dy;
      return [width / 2 + scale * (cy * dx - sy * dy), height / 2 - scale * (cp * dz + sp * away), cp * away - sp * dz];
    };
    const [least, most] = range();
    const visible = [];
    for (let k = 0; k < n; ++k) {
      if (places[axis][k] < bound) continue;
      const at = project(bed.x[k], bed.y[k], bed.z[k]);
      visible.push({ k: k, x: at[0], y: at[1], depth: at[2], r: Math.max(0.7, scale * radius(k)) });
    }
    visible.sort(function (a, b) { return b.depth - a.depth; });
    make_stamps((window.devicePixelRatio || 1) * Math.max(1, visible.reduce(function (r, p) { return Math.max(r, p.r); }, 0)));

    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(function (c) {
      return project(c & 1 ? high[0] : low[0], c & 2 ? high[1] : low[1], c & 4 ? high[2] : low[2]);
    });
    context.strokeStyle = shades.rule;
    [[0, 1], [0, 2], [1, 3], [2, 3], [4, 5], [4, 6], [5, 7], [6, 7], [0, 4], [1, 5], [2, 6], [3, 7]].forEach(function (edge) {
      context.beginPath();
      context.moveTo(corners[edge[0]][0], corners[edge[0]][1]);
      context.lineTo(corners[edge[1]][0], corners[edge[1]][1]);
      context.stroke();
    });
    visible.forEach(function (p) {
      const s = marked >= 0 && bed.warp[p.k] !== marked ? n_shades
                                                         : Math.round((chosen.of[p.k] - least) / (most - least) * (n_shades - 1));
      context.drawImage(stamps[s], p.x - p.r, p.y - p.r, 2 * p.r, 2 * p.r);
    });
    drawn = visible;
    draw_axes(context, project, 28 / scale);
    cut_at.textContent = ["x", "y", "z"][axis] + " from " + warpgrain.number(bound * bed.unit) + " m";
  };
  // Which way x, y and z point, in the lower left corner.
  const draw_axes = function (context, project, reach) {
    const origin = project(middle[0], middle[1], middle[2]);
    context.font = "12px system-ui, sans-serif";
    context.strokeStyle = context.fillStyle = shades.ink;
    context.textAlign = "center";
    context.textBaseline = "middle";
    ["x", "y", "z"].forEach(function (name, d) {
      const to = project(middle[0] + (d === 0), middle[1] + (d === 1), middle[2] + (d === 2));
      const x = 46 + reach * (to[0] - origin[0]), y = height - 46 + reach * (to[1] - origin[1]);
      context.beginPath();
      context.moveTo(46, height - 46);
      context.lineTo(x, y);
      context.stroke();
      context.fillText(name, 46 + 1.35 * (x - 46), height - 46 + 1.35 * (y - (height - 46)));
    });
  };
  const show_legend = function () {
    const [least, most] = range();
    const bar = stops.map(function (unused, k) { return shade(k / (stops.length - 1), 1); }).join(",");
    legend.innerHTML = warpgrain.escaped(chosen.label) + ": " + warpgrain.number(least) + " <i class=\"ramp\" style=\"background:linear-gradient(to right," +
      bar + ")\"></i> " + warpgrain.number(most);
  };
  const particle_at = function (x, y) {
    for (let i = drawn.length - 1; i >= 0; --i)
      if (Math.hypot(drawn[i].x - x, drawn[i].y - y) <= drawn[i].r) return drawn[i].k;
    return -1;
  };
  const hint = "Drag to turn; point at a particle for its values" + (bed.kernel ? "; a click marks the particles of its warp." : ".");

  let held = null, waiting = false;
  const draw_soon = function () {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(function () { waiting = false; draw(); });
  };
  canvas.addEventListener("pointerdown", function (event) {
    held = { x: event.offsetX, y: event.offsetY, yaw: yaw, pitch: pitch, moved: false };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointerup", function () { setTimeout(function () { held = null; }, 0); });
  canvas.addEventListener("pointermove", function (event) {
    if (held) {
      held.moved = held.moved || Math.abs(event.offsetX - held.x) + Math.abs(event.offsetY - held.y) > 3;
      yaw = held.yaw - (event.offsetX - held.x) / 150;
      pitch = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, held.pitch + (event.offsetY - held.y) / 150));
      return draw_soon();
    }
    const k = particle_at(event.offsetX, event.offsetY);
    readout.textContent = k < 0 ? hint : bed.contacts[k] + " contacts, " + bed.candidates[k] + " candidates" +
      (bed.kernel ? "; warp " + bed.warp[k].toLocaleString("en") + " of " + bed.kernel + ", SIMT efficiency " + bed.efficiency[k].toFixed(3) : "") +
      "; at " + places.map(function (p) { return warpgrain.number(p[k] * bed.unit); }).join(", ") + " m";
  });
  canvas.addEventListener("click", function (event) {
    if (!bed.kernel || (held && held.moved)) return;
    const k = particle_at(event.offsetX, event.offsetY);
    marked = k < 0 || bed.warp[k] === marked ? -1 : bed.warp[k];
    draw();
  });
  colour_choice.addEventListener("change", function () { chosen = values[colour_choice.value]; show_legend(); draw(); });
  axis_choice.addEventListener("change", function () { axis = Number(axis_choice.value); draw(); });
  slice.addEventListener("input", function () { cut = Number(slice.value); draw_soon(); });
  window.addEventListener("resize", draw_soon);
  readout.textContent = hint;
  show_legend();
  draw();
});
