// Work and precision: the error against the time it takes.

import { draw, logAxis } from "./chart.js";
import { styleOf } from "./curve_style.js";
import { errorText, quantityText, stepText } from "./text.js";

function curveTrace(curve) {
  const { colour: ink, symbol } = styleOf(curve.number);
  const points = curve.points.points.filter((point) => point.seconds > 0 && point.error > 0);
  return {
    x: points.map((point) => point.seconds),
    y: points.map((point) => point.error),
    mode: "lines+markers",
    line: { color: ink, width: 1.8 },
    marker: { color: ink, symbol, size: 6 },
    name: curve.label,
    text: points.map((point) => `h = ${stepText(point.h)}<br>error ${errorText(point.error)}`),
    hovertemplate: "%{text}<br>%{x:.3~s}s<extra>%{fullData.name}</extra>",
    meta: "work",
  };
}

export function drawWork(selection) {
  const curves = selection.curves.filter((curve) => curve.visible && curve.points);
  const traces = curves.map(curveTrace);
  draw("work-chart", "Error against evaluation time", traces, {
    x: logAxis("seconds", traces.flatMap((trace) => trace.x)),
    y: logAxis(`${selection.norm} error of ${quantityText(selection.quantity)}`, traces.flatMap((trace) => trace.y)),
    shown: selection.quantity + selection.norm,
  });
}
