// Charts of ECharts in the page's colours: warpgrain.draw(element, rows, option). What draws a div.chart is the function of its
// kind in warpgrain.kinds, which the other files fill in.
"use strict";
warpgrain.kinds = {};
(function () {
  const shades = warpgrain.shades;

  // The library's text is in the page, and run for the first chart: it takes longer than all else that a page does to open.
  const need_library = function () {
    if (typeof echarts !== "undefined") return;
    const code = document.createElement("script");
    code.textContent = document.getElementById("chart_library").textContent;
    document.head.append(code);
  };
  warpgrain.chart_in = function (element) {
    return typeof echarts === "undefined" ? undefined : echarts.getInstanceByDom(element);
  };

  const name_of = function (element) {
    const heading = element.closest("td") ? null : element.parentElement.querySelector("h3");
    const title = element.dataset.title || (heading ? heading.textContent : "chart");
    return title.toLowerCase().replace(/[^a-z0-9]+/g, "_").slice(0, 40);
  };
  const svg_of = function (element) {
    return warpgrain.chart_in(element).getDataURL({ type: "svg", backgroundColor: shades.paper });
  };
  const save_png = function (element) {
    const picture = new Image(), times = 2;
    picture.onload = function () {
      const canvas = document.createElement("canvas");
      canvas.width = times * element.clientWidth;
      canvas.height = times * element.clientHeight;
      canvas.getContext("2d").drawImage(picture, 0, 0, canvas.width, canvas.height);
      warpgrain.save_canvas(name_of(element), canvas);
    };
    picture.src = svg_of(element);
  };
  const add_exports = function (element) {
    const buttons = document.createElement("p");
    buttons.className = "exports";
    buttons.append(warpgrain.button("SVG", function () { warpgrain.save_url(name_of(element) + ".svg", svg_of(element)); }),
                   warpgrain.button("PNG", function () { save_png(element); }),
                   warpgrain.button("CSV", function () { warpgrain.save_table(name_of(element), element.rows); }));
    element.after(buttons);
  };

  // `rows` of the data that is drawn, the first with headings. A second call draws anew.
  warpgrain.draw = function (element, rows, option) {
    need_library();
    const old = warpgrain.chart_in(element);
    if (old) old.dispose();
    else add_exports(element);
    element.rows = rows;
    const chart = echarts.init(element, null, { renderer: "svg" });
    const axis = { axisLine: { lineStyle: { color: shades.rule } }, axisLabel: { color: shades.soft }, nameTextStyle: { color: shades.soft },
                   splitLine: { lineStyle: { color: shades.rule } }, nameLocation: "middle", nameGap: 30 };
    ["xAxis", "yAxis"].forEach(function (key) { if (option[key]) option[key] = Object.assign({}, axis, option[key]); });
    chart.setOption(Object.assign({
      color: warpgrain.palette, animation: false, textStyle: { color: shades.ink },
      grid: { left: 70, right: 30, top: 40, bottom: 50 },
      legend: { textStyle: { color: shades.soft }, pageTextStyle: { color: shades.soft }, type: "scroll", top: 0, bottom: "auto", left: 0, right: 0 },
      tooltip: { backgroundColor: shades.panel, borderColor: shades.rule, textStyle: { color: shades.ink }, confine: true }
    }, option), true);
    return chart;
  };
})();
