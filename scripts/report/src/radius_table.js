// How the curvatures of a surface spread at each radius, in numbers: rows of one quantity stand together.

import { studyName } from "./curves.js";
import { byId, element } from "./elements.js";
import { countText, errorText, quantityText, stepText } from "./text.js";

const order = ["mean", "gaussian", "k1", "k2"]; // of the quantities; others come behind
const place = (quantity) => (order.includes(quantity) ? order.indexOf(quantity) : order.length);

/** 0 and 1 are the ends. */
function probabilityText(probability) {
  return { 0: "least", 0.5: "median", 1: "greatest" }[probability] ?? `${Number((100 * probability).toPrecision(3))} %`;
}

function rowOf(quantity, { digital_radius, radius, quantities }) {
  const { mean, quantiles } = quantities[quantity];
  const numbers = [stepText(digital_radius), stepText(radius), ...[mean, ...quantiles].map(errorText)];
  const cells = numbers.map((text) => element("td", { class: "number" }, text));
  return element("tr", {}, element("td", {}, quantityText(quantity)), ...cells);
}

function tableOf(study, studies) {
  const { input, h, surfels, components, estimator, levels } = study.detail;
  const quantities = Object.keys(levels[0].quantities).sort((a, b) => place(a) - place(b));
  const { probabilities } = levels[0].quantities[quantities[0]];
  const titles = ["R/h", "R", "mean", ...probabilities.map(probabilityText)];
  const head = [
    element("th", { scope: "col" }, "quantity"),
    ...titles.map((title) => element("th", { scope: "col", class: "number" }, title)),
  ];
  const parts = components === 1 ? "" : `, ${countText(components)} components`;
  const what = `${input}, h = ${stepText(h)}, ${estimator}: ${countText(surfels)} surfels${parts}`;
  const several = studies.length > 1 ? `${studyName(study, studies)}: ` : "";
  const rows = quantities.flatMap((quantity) => levels.map((level) => rowOf(quantity, level)));
  return element(
    "table",
    {},
    element("caption", {}, several + what),
    element("thead", {}, element("tr", {}, ...head)),
    element("tbody", {}, ...rows),
  );
}

/** A table a study, or no section where there are none. */
export function showRadii(studies) {
  byId("radii").hidden = !studies.length;
  byId("radii").querySelector(".scroll").replaceChildren(...studies.map((study) => tableOf(study, studies)));
}
