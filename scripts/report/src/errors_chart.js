// Error against h: mean over the shifts, band, fit, and the exponents that theorems give.

import { band, draw, logAxis } from "./chart.js";
import { styleOf, translucent } from "./curve_style.js";
import { colour } from "./theme.js";
import { errorText, powerText, quantityText, slopeText, stepText } from "./text.js";

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
const ends = (values) => [Math.min(...values), Math.max(...values)];

/** By level, from the errors of its shifts. A level that is zero throughout has no place on a logarithmic axis. */
export function meansOf(series) {
  return series.levels
    .map(({ h, errors }) => ({ h, mean: mean(errors), least: Math.min(...errors), largest: Math.max(...errors) }))
    .filter((level) => level.mean > 0);
}

function curveTraces(curve) {
  const { colour: ink, symbol } = styleOf(curve.number);
  const levels = meansOf(curve.series);
  const h = levels.map((level) => level.h);
  const least = levels.map((level) => level.least || level.mean);
  const { slope, constant } = curve.series;
  const fit = {
    x: ends(h),
    y: ends(h).map((step) => constant * step ** slope),
    mode: "lines",
    line: { color: ink, width: 1.2, dash: "dash" },
    opacity: 0.8,
    hoverinfo: "skip",
    meta: "fit",
  };
  return [
    ...band(h, least, levels.map((level) => level.largest), translucent(ink, 0.16)),
    ...(constant > 0 ? [fit] : []),
    {
      x: h,
      y: levels.map((level) => level.mean),
      mode: "lines+markers",
      line: { color: ink, width: 1.8 },
      marker: { color: ink, symbol, size: 7 },
      name: curve.label,
      text: levels.map(
        (level) =>
          `h = ${stepText(level.h)}<br>${errorText(level.mean)}, from ${errorText(level.least)} to ${errorText(level.largest)}`,
      ),
      hovertemplate: "%{text}<extra>%{fullData.name}</extra>",
      meta: "mean",
    },
  ];
}

/** One line an exponent, just below all errors. */
function referenceLines(curves, levels) {
  const exponents = [...new Set(curves.map(({ series }) => series.expected).filter((p) => p !== null))];
  if (!levels.length) return { traces: [], annotations: [] };
  const [from, to] = ends(levels.map(({ h }) => h));
  const lines = exponents.map((p) => ({ p, constant: 0.75 * Math.min(...levels.map((l) => l.least / l.h ** p).filter((c) => c > 0)) }));
  return {
    traces: lines.map(({ p, constant }) => ({
      x: [from, to],
      y: [from, to].map((h) => constant * h ** p),
      mode: "lines",
      line: { color: colour("soft"), width: 1.5, dash: "dot" },
      hoverinfo: "skip",
      meta: "reference",
    })),
    annotations: lines.map(({ p, constant }) => ({
      x: Math.log10(from),
      y: Math.log10(constant * from ** p),
      text: powerText(p).replace(/\^\(?([^)]*)\)?/, "<sup>$1</sup>"),
      showarrow: false,
      xanchor: "left",
      yanchor: "top",
      font: { color: colour("soft"), size: 14 },
    })),
  };
}

export function drawErrors(selection) {
  const curves = selection.curves.filter((curve) => curve.visible);
  const levels = curves.flatMap(({ series }) => meansOf(series));
  const reference = referenceLines(curves, levels);
  const spoken = curves.map((curve) => `${curve.label}: slope ${slopeText(curve.series.slope)}`).join("; ");
  draw("errors-chart", `Error against h. ${spoken}`, [...reference.traces, ...curves.flatMap(curveTraces)], {
    x: logAxis("h", levels.map(({ h }) => h)),
    y: logAxis(`${selection.norm} error of ${quantityText(selection.quantity)}`, levels.flatMap((l) => [l.least, l.largest])),
    shown: selection.quantity + selection.norm,
    annotations: reference.annotations,
  });
}
