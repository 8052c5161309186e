// The slope as coarse steps are dropped, with its interval.

import { band, draw, linearAxis, logAxis } from "./chart.js";
import { styleOf, translucent } from "./curve_style.js";
import { colour } from "./theme.js";
import { intervalText, slopeText, stepText } from "./text.js";

function curveTraces(curve) {
  const { colour: ink, symbol } = styleOf(curve.number);
  const { scan } = curve.series;
  const bounded = scan.filter(({ interval }) => interval[0] !== null && interval[1] !== null);
  return [
    ...band(
      bounded.map((row) => row.coarsest),
      bounded.map((row) => row.interval[0]),
      bounded.map((row) => row.interval[1]),
      translucent(ink, 0.14),
    ),
    {
      x: scan.map((row) => row.coarsest),
      y: scan.map((row) => row.slope),
      mode: "lines+markers",
      line: { color: ink, width: 1.8 },
      marker: { color: ink, symbol, size: 6 },
      name: curve.label,
      text: scan.map((row) => `h ≤ ${stepText(row.coarsest)}<br>slope ${slopeText(row.slope)} ${intervalText(row.interval)}`),
      hovertemplate: "%{text}<extra>%{fullData.name}</extra>",
      meta: "scan",
    },
  ];
}

function referenceLines(curves) {
  const steps = curves.flatMap(({ series }) => series.scan.map((row) => row.coarsest));
  const exponents = [...new Set(curves.map(({ series }) => series.expected).filter((p) => p !== null))];
  return exponents.map((p) => ({
    x: [Math.min(...steps), Math.max(...steps)],
    y: [p, p],
    mode: "lines",
    line: { color: colour("soft"), width: 1.5, dash: "dot" },
    name: `theory ${slopeText(p)}`,
    hovertemplate: "%{fullData.name}<extra></extra>",
    meta: "reference",
  }));
}

export function drawScan(selection) {
  const curves = selection.curves.filter((curve) => curve.visible && curve.series.scan.length);
  draw("scan-chart", "Slope against the coarsest h kept", [...referenceLines(curves), ...curves.flatMap(curveTraces)], {
    x: logAxis("coarsest h kept", curves.flatMap(({ series }) => series.scan.map((row) => row.coarsest))),
    y: linearAxis("slope"),
    shown: selection.quantity + selection.norm,
  });
}
