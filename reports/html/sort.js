// A click on a heading of a table.sortable sorts its rows by that column: by data-v where cells have it, else by text.
"use strict";
document.querySelectorAll("table.sortable").forEach(function (table) {
  const headings = Array.from(table.tHead.rows[0].cells);
  headings.forEach(function (heading, column) {
    heading.addEventListener("click", function () {
      const descending = heading.getAttribute("aria-sort") !== "descending";
      headings.forEach(function (other) { other.removeAttribute("aria-sort"); });
      heading.setAttribute("aria-sort", descending ? "descending" : "ascending");
      const key = function (row) {
        const cell = row.cells[column];
        return cell.dataset.v === undefined ? cell.textContent : Number(cell.dataset.v);
      };
      const compare = function (a, b) {
        const x = key(a), y = key(b);
        return typeof x === "number" ? (typeof y === "number" ? x - y : 1)
             : typeof y === "number" ? -1 : x.localeCompare(y);
      };
      const body = table.tBodies[0];
      const rows = Array.from(body.rows).sort(compare);
      if (descending) rows.reverse();
      rows.forEach(function (row) { body.appendChild(row); });
    });
  });
});
