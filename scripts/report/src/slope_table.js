// The table of slopes and verdicts; a click on a column's title sorts by it.

import { verdictElement } from "./curve_list.js";
import { byId, element } from "./elements.js";
import { meansOf } from "./errors_chart.js";
import { errorText, intervalText, radiusText, slopeText, stepText } from "./text.js";

const finest = (row) => row.levels.at(-1);
const finestError = (row) => meansOf(row).at(-1)?.mean ?? 0;

// title, what is sorted by, what is shown where that is something else
const columns = [
  { title: "study", value: (row) => row.study, only: (rows) => new Set(rows.map((row) => row.study)).size > 1 },
  { title: "shape", value: (row) => (row.rotated ? `${row.shape}, rotated` : row.shape) },
  { title: "estimator", value: (row) => row.estimator },
  { title: "R", value: (row) => row.k ?? -1, show: (row) => radiusText(row).replace("R = ", "") || "–" },
  { title: "noise", value: (row) => row.noise, only: (rows) => rows.some((row) => row.noise > 0) },
  { title: "quantity", value: (row) => row.quantity },
  { title: "norm", value: (row) => row.norm },
  { title: "finest h", value: (row) => finest(row).h, show: (row) => stepText(finest(row).h) },
  { title: "error there", value: finestError, show: (row) => errorText(finestError(row)) },
  {
    title: "fallbacks there",
    value: (row) => row.fallbacks,
    show: (row) => (row.fallbacks > 0 ? `${(100 * row.fallbacks).toPrecision(3)} %` : "none"),
    only: (rows) => rows.some((row) => row.fallbacks > 0),
  },
  { title: "slope", value: (row) => row.slope, show: (row) => slopeText(row.slope) },
  { title: "95 %", value: (row) => row.interval[0] ?? -Infinity, show: (row) => intervalText(row.interval) },
  { title: "robust", value: (row) => row.theil_sen, show: (row) => slopeText(row.theil_sen) },
  { title: "envelope", value: (row) => row.envelope_slope, show: (row) => slopeText(row.envelope_slope) },
  { title: "theory", value: (row) => row.expected ?? -Infinity, show: (row) => (row.expected === null ? "–" : slopeText(row.expected)) },
  { title: "verdict", value: (row) => row.verdict, show: (row) => verdictElement(row.verdict) },
];

const compare = (a, b) => (typeof a === "string" ? a.localeCompare(b) : a - b);

export class SlopeTable {
  #column = null;
  #descending = false;
  #rows = [];

  show(rows) {
    this.#rows = rows;
    const shown = columns.filter((column) => !column.only || column.only(rows));
    const sorted = [...rows];
    if (this.#column) sorted.sort((a, b) => compare(this.#column.value(a), this.#column.value(b)) * (this.#descending ? -1 : 1));
    const isNumber = (column) => rows.length > 0 && typeof column.value(rows[0]) === "number";
    const head = element("tr", {}, ...shown.map((column) => this.#title(column, isNumber(column))));
    const body = sorted.map((row) =>
      element(
        "tr",
        {},
        ...shown.map((column) =>
          element("td", isNumber(column) ? { class: "number" } : {}, (column.show ?? column.value)(row)),
        ),
      ),
    );
    byId("slopes").replaceChildren(element("thead", {}, head), element("tbody", {}, ...body));
  }

  #title(column, isNumber) {
    const button = element("button", { type: "button" }, column.title);
    const title = element("th", { scope: "col", ...(isNumber ? { class: "number" } : {}) }, button);
    if (column === this.#column) title.setAttribute("aria-sort", this.#descending ? "descending" : "ascending");
    button.addEventListener("click", () => {
      this.#descending = column === this.#column && !this.#descending;
      this.#column = column;
      this.show(this.#rows);
      [...byId("slopes").querySelectorAll("th button")].find((b) => b.textContent === column.title).focus();
    });
    return title;
  }
}
