// A field above each long table: rows that have all of its words stay.
"use strict";
document.querySelectorAll("table.sortable").forEach(function (table) {
  const body = table.tBodies[0];
  if (8 > body.rows.length) return;
  const field = document.createElement("input");
  field.type = "search";
  field.placeholder = "filter rows";
  field.setAttribute("aria-label", "filter rows");
  field.addEventListener("input", function () {
    const words = field.value.toLowerCase().split(/\s+/);
    Array.from(body.rows).forEach(function (row) {
      const text = row.textContent.toLowerCase();
      row.hidden = !words.every(function (word) { return text.includes(word); });
    });
  });
  table.before(field);
});
