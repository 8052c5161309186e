// Evaluation time against h, and the exponents at which time and work grow.

import { draw, logAxis } from "./chart.js";
import { styleOf } from "./curve_style.js";
import { byId, element } from "./elements.js";
import { exponentText, stepText } from "./text.js";

// The same colour for all evaluations of a curve.
const evaluations = {
  full: { dash: "dot", suffix: "-open" },
  masks: { dash: "solid", suffix: "" },
  bricks: { dash: "dashdot", suffix: "-dot" },
};

/** The fitted line: least squares in logarithms go through the mean of the points. */
export function fitOf(steps, exponent) {
  const meanLog = (values) => values.reduce((sum, value) => sum + Math.log(value), 0) / values.length;
  const timed = steps.filter((step) => step.seconds_eval > 0);
  const constant = Math.exp(
    meanLog(timed.map((step) => step.seconds_eval)) - exponent * meanLog(timed.map((step) => step.h)),
  );
  return (h) => constant * h ** exponent;
}

function costTraces(curve, cost) {
  const { colour: ink, symbol } = styleOf(curve.number);
  const name = [curve.label, cost.evaluation].filter(Boolean).join(", ");
  const h = cost.steps.map((step) => step.h);
  const { dash, suffix } = evaluations[cost.evaluation] ?? evaluations.masks;
  const measured = {
    x: h,
    y: cost.steps.map((step) => step.seconds_eval),
    mode: "lines+markers",
    line: { color: ink, width: 1.8, dash },
    marker: { color: ink, symbol: symbol + suffix, size: 6 },
    name,
    text: cost.steps.map((step) => `h = ${stepText(step.h)}`),
    hovertemplate: "%{text}<br>%{y:.3~s}s<extra>%{fullData.name}</extra>",
    meta: "time",
  };
  if (cost.time_in_h === null) return [measured];
  const ends = [Math.min(...h), Math.max(...h)];
  const line = { color: ink, width: 1, dash: "dash" };
  return [
    { x: ends, y: ends.map(fitOf(cost.steps, cost.time_in_h)), mode: "lines", line, hoverinfo: "skip", meta: "fit" },
    measured,
  ];
}

function fillExponents(curves) {
  const several = curves.some(({ costs }) => costs.some(({ evaluation }) => evaluation !== null));
  const titles = ["curve", ...(several ? ["evaluation"] : []), "time", "cells", "theory"];
  const head = element("tr", {}, ...titles.map((title) => element("th", { scope: "col" }, title)));
  const rows = curves.flatMap((curve) =>
    curve.costs.map((cost) => {
      const { colour: ink, glyph } = styleOf(curve.number);
      const swatch = element("span", { class: "swatch", style: `color:${ink}`, "aria-hidden": "true" }, glyph);
      const numbers = [cost.time_in_h, cost.cells_in_h, cost.expected_in_h];
      return element(
        "tr",
        {},
        element("td", { class: "label" }, swatch, curve.label),
        ...(several ? [element("td", {}, cost.evaluation ?? "–")] : []),
        ...numbers.map((number) => element("td", { class: "number" }, number === null ? "–" : exponentText(number))),
      );
    }),
  );
  const caption = element("caption", {}, "Exponents of h: time, cells read, and cells in theory");
  byId("exponents").replaceChildren(caption, element("thead", {}, head), element("tbody", {}, ...rows));
}

export function drawTime(selection) {
  const curves = selection.curves.filter((curve) => curve.visible);
  const traces = curves.flatMap((curve) => curve.costs.flatMap((cost) => costTraces(curve, cost)));
  draw("time-chart", "Evaluation time against h", traces, {
    x: logAxis("h", traces.flatMap((trace) => trace.x)),
    y: logAxis("seconds", traces.flatMap((trace) => trace.y)),
  });
  fillExponents(curves);
}
