// div.timeline: what a warp did, a column an execution of a block, a row a lane. Coloured where the lane was active, by the
// file that the block is from. Wheel and drag zoom and move; a click goes to the source line.
"use strict";
document.querySelectorAll("div.timeline").forEach(function (element) {
  const data = JSON.parse(element.dataset.timeline);
  const shades = warpgrain.shades, width = data.width, left = 44, strip = 46, gap = 10, foot = 26;
  const row_height = Math.max(4, Math.min(16, Math.floor(288 / width)));
  const files = Array.from(new Set(data.blocks.filter(function (b) { return b.used; }).map(function (b) { return b.file; })));
  const colour_of = function (file) { return warpgrain.palette[files.indexOf(file) % warpgrain.palette.length]; };

  const warps = data.warps.map(function (warp) {
    const lanes = warp.lanes.split(" ").map(function (mask) { return BigInt("0x" + (mask || "0")); });
    const active = lanes.map(function (mask) { return mask.toString(2).split("1").length - 1; });
    // Where each execution begins, by instructions issued so far.
    const begins = [0];
    warp.blocks.forEach(function (block, k) { begins.push(begins[k] + Math.max(1, data.blocks[block].instructions)); });
    return Object.assign({}, warp, { lanes: lanes, active: active, begins: begins });
  });
  let warp = warps[0], by_instructions = false, from = 0, to = 1;

  const controls = document.createElement("p");
  controls.className = "controls";
  const choice = document.createElement("select");
  choice.setAttribute("aria-label", "warp");
  warps.forEach(function (w, k) {
    choice.add(new Option("warp " + w.warp.toLocaleString("en") + " (" + w.chosen_as.join(", ") + "): efficiency " +
                          w.efficiency.toFixed(3) + ", " + w.executions.toLocaleString("en") + " block executions", k));
  });
  const scale = document.createElement("select");
  scale.setAttribute("aria-label", "width of a column");
  scale.add(new Option("columns of one width", "0"));
  scale.add(new Option("as wide as the block has instructions", "1"));
  const canvas = document.createElement("canvas");
  const readout = document.createElement("p");
  readout.className = "readout";
  const legend = document.createElement("p");
  legend.className = "legend";
  const name = "warp_timeline";
  controls.append(choice, " ", scale, " ", warpgrain.button("+", function () { zoom(0.5, 0.5); }),
                  warpgrain.button("−", function () { zoom(2, 0.5); }), warpgrain.button("all", function () { from = 0; to = 1; draw(); }), " ",
                  warpgrain.button("PNG", function () { warpgrain.save_canvas(name, canvas); }),
                  warpgrain.button("CSV", function () { warpgrain.save_table(name, table()); }));
  element.append(controls, legend, canvas, readout);

  const n = function () { return warp.blocks.length; };
  // Where the k-th execution begins, from 0 to 1.
  const place = function (k) { return by_instructions ? warp.begins[k] / warp.begins[n()] : k / n(); };
  const plot_width = function () { return element.clientWidth - left - 8; };
  const x_of = function (k) { return left + (place(k) - from) / (to - from) * plot_width(); };
  const execution_at = function (x) {
    const share = from + (x - left) / plot_width() * (to - from);
    if (share < 0 || share >= 1 || x < left) return -1;
    if (!by_instructions) return Math.floor(share * n());
    const at = share * warp.begins[n()];
    let low = 0, high = n();
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (warp.begins[middle] <= at) low = middle; else high = middle;
    }
    return low;
  };
  const table = function () {
    return [["execution", "block", "file", "line", "instructions", "active lanes", "lanes"]].concat(warp.blocks.map(function (b, k) {
      const block = data.blocks[b];
      return [k, block.label, block.file, block.line, block.instructions, warp.active[k], "0x" + warp.lanes[k].toString(16)];
    }));
  };

  const draw = function (marked) {
    const top = strip + gap, bottom = top + width * row_height, context = warpgrain.sharp(canvas, element.clientWidth, bottom + foot);
    const right = left + plot_width();
    context.font = "11px system-ui, sans-serif";
    context.fillStyle = shades.panel;
    context.fillRect(left, top, plot_width(), bottom - top);
    context.save();
    context.beginPath();
    context.rect(left, 0, plot_width(), bottom);
    context.clip();
    const first = Math.max(0, execution_at(left)), last = to >= 1 ? n() - 1 : Math.max(0, execution_at(right));
    for (let k = first; k <= last; ++k) {
      const x = x_of(k), w = x_of(k + 1) - x, inner = w > 4 ? w - 1 : w;
      const block = data.blocks[warp.blocks[k]];
      context.fillStyle = shades.soft;
      const high = strip * warp.active[k] / width;
      context.fillRect(x, strip - high, inner, high);
      context.fillStyle = colour_of(block.file);
      const mask = warp.lanes[k];
      for (let lane = 0; lane < width; ++lane) {
        let run = lane;  // neighbours in one rectangle
        while (run < width && (mask >> BigInt(run)) & 1n) ++run;
        if (run === lane) continue;
        context.fillRect(x, top + lane * row_height, inner, (run - lane) * row_height - (row_height > 5 ? 1 : 0));
        lane = run;
      }
    }
    if (marked >= 0) {
      context.strokeStyle = shades.ink;
      context.strokeRect(x_of(marked) - 0.5, 0.5, Math.max(2, x_of(marked + 1) - x_of(marked)), bottom - 1);
    }
    context.restore();
    context.fillStyle = shades.soft;
    context.textAlign = "right";
    context.textBaseline = "middle";
    [[0, strip], [width, 5]].forEach(function (tick) { context.fillText(String(tick[0]), left - 6, tick[1]); });
    for (let lane = 0; lane < width; lane += width / 8 >= 1 ? width / 8 : 1)
      context.fillText("lane " + lane, left - 4, top + (lane + 0.5) * row_height);
    context.textBaseline = "top";
    [0, 0.25, 0.5, 0.75, 1].forEach(function (share) {
      const x = left + share * plot_width(), at = from + share * (to - from);
      context.textAlign = share === 0 ? "left" : share === 1 ? "right" : "center";
      const value = by_instructions ? at * warp.begins[n()] : at * n();
      context.fillText(Math.round(value).toLocaleString("en") + (share === 1 ? (by_instructions ? " instructions" : " block executions") : ""),
                       x, bottom + 6);
    });
  };
  const zoom = function (factor, share) {
    const middle = from + share * (to - from), size = Math.min(1, Math.max(8 / n(), (to - from) * factor));
    from = Math.min(1 - size, Math.max(0, middle - share * size));
    to = from + size;
    draw();
  };
  const describe = function (k) {
    const block = data.blocks[warp.blocks[k]];
    const idle = width - warp.active[k];
    readout.innerHTML = "<b>" + (k + 1).toLocaleString("en") + "</b> of " + n().toLocaleString("en") + ": <b>" + warp.active[k] + "</b> of " + width +
      " lanes, " + idle * block.instructions + " lane slots idle; block <code>" + warpgrain.escaped(block.label) + "</code>, " +
      block.instructions + " instructions" +
      (block.line ? "; <code>" + warpgrain.escaped(block.file) + ":" + block.line + "</code> <code>" + warpgrain.escaped(block.text) + "</code>" : "");
  };
  const choose = function () {
    const used = new Map();
    warp.blocks.forEach(function (b, k) {
      const file = data.blocks[b].file, sum = used.get(file) || { issued: 0, active: 0 };
      sum.issued += data.blocks[b].instructions;
      sum.active += data.blocks[b].instructions * warp.active[k];
      used.set(file, sum);
    });
    const all = warp.begins[n()];
    legend.innerHTML = Array.from(used).sort(function (a, b) { return b[1].issued - a[1].issued; }).map(function (entry) {
      return "<span><i style=\"background:" + colour_of(entry[0]) + "\"></i>" + warpgrain.escaped(entry[0] || "no source line") + " <span class=\"soft\">" +
        (100 * entry[1].issued / all).toFixed(0) + " % of the instructions, " + (entry[1].active / Math.max(1, entry[1].issued)).toFixed(1) +
        " lanes</span></span>";
    }).join(" ");
    readout.textContent = (warp.executions > n() ? "Cut: the first " + n().toLocaleString("en") + " of " + warp.executions.toLocaleString("en") +
      " block executions. " : "") + "Point at a column; a click shows its source line, the wheel zooms, dragging moves.";
    from = 0;
    to = 1;
    draw();
  };
  const go_to_source = function (block) {
    const section = element.closest("details");
    if (!section || !block.line) return;
    let file = "";
    Array.from(section.querySelectorAll("table.source tbody tr")).some(function (row) {
      const heading = row.querySelector("td.text"), line = row.querySelector("td.number");
      if (heading) file = heading.textContent;
      if (!line || file !== block.file || Number(line.textContent) !== block.line) return false;
      row.scrollIntoView({ block: "center" });
      row.classList.add("found");
      setTimeout(function () { row.classList.remove("found"); }, 2500);
      return true;
    });
  };

  let held = null;
  canvas.addEventListener("wheel", function (event) {
    if (!event.ctrlKey && Math.abs(event.deltaX) > Math.abs(event.deltaY)) return;
    event.preventDefault();
    zoom(event.deltaY > 0 ? 1.25 : 0.8, Math.min(1, Math.max(0, (event.offsetX - left) / plot_width())));
  }, { passive: false });
  canvas.addEventListener("pointerdown", function (event) { held = { x: event.offsetX, from: from, moved: false }; });
  window.addEventListener("pointerup", function () { setTimeout(function () { held = null; }, 0); });
  canvas.addEventListener("pointermove", function (event) {
    if (held) {
      const size = to - from;
      held.moved = held.moved || Math.abs(event.offsetX - held.x) > 3;
      from = Math.min(1 - size, Math.max(0, held.from - (event.offsetX - held.x) / plot_width() * size));
      to = from + size;
    }
    const k = execution_at(event.offsetX);
    draw(k);
    if (k >= 0) describe(k);
  });
  canvas.addEventListener("click", function (event) {
    const k = execution_at(event.offsetX);
    if (k >= 0 && !(held && held.moved)) go_to_source(data.blocks[warp.blocks[k]]);
  });
  choice.addEventListener("change", function () { warp = warps[Number(choice.value)]; choose(); });
  scale.addEventListener("change", function () { by_instructions = scale.value === "1"; draw(); });
  window.addEventListener("resize", function () { draw(); });
  // Of a closed section nothing has a width yet.
  const section = element.closest("details");
  if (section) section.addEventListener("toggle", function () { if (section.open) draw(); });
  choose();
});
