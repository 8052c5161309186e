// The legend of all charts: a button a curve, with its slope and verdict.

import { styleOf } from "./curve_style.js";
import { byId, element } from "./elements.js";
import { intervalText, slopeText } from "./text.js";

export function verdictElement(verdict) {
  return element("span", { class: `verdict ${verdict.replaceAll(" ", "-")}` }, verdict);
}

function curveButton(curve, selection) {
  const { colour: ink, glyph } = styleOf(curve.number);
  const { slope, interval, verdict, constant } = curve.series;
  const button = element(
    "button",
    { type: "button", "aria-pressed": String(curve.visible), "data-key": curve.key },
    element("span", { class: "swatch", style: `color:${ink}`, "aria-hidden": "true" }, glyph),
    element("span", { class: "label" }, curve.label),
    element("span", { class: "slope" }, constant > 0 ? `${slopeText(slope)} ${intervalText(interval)}` : "no slope"),
    verdictElement(verdict),
  );
  button.addEventListener("click", () => {
    selection.toggle(curve);
    [...byId("curves").querySelectorAll("button")].find((other) => other.dataset.key === curve.key)?.focus();
  });
  return button;
}

export function showCurves(selection) {
  byId("curves").replaceChildren(...selection.curves.map((curve) => element("li", {}, curveButton(curve, selection))));
}
