// What all charts have in common.

import Plotly from "plotly.js-basic-dist-min";
import { colour } from "./theme.js";

const config = {
  responsive: true,
  displaylogo: false,
  modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d", "zoomIn2d", "zoomOut2d"],
};

const fewDecades = 2.5; // over which 2 and 5 are written between the powers of ten

/** `values` are those shown, of any sign. */
export function logAxis(title, values) {
  const logs = values.filter((value) => value > 0).map(Math.log10);
  const decades = logs.length ? Math.max(...logs) - Math.min(...logs) : 0;
  const dtick = decades < fewDecades ? "D2" : Math.ceil(decades / 8);
  return { title: { text: title, standoff: 8 }, type: "log", exponentformat: "power", dtick };
}

export function linearAxis(title) {
  return { title: { text: title, standoff: 8 } };
}

function styled(axis) {
  const line = { gridcolor: colour("grid"), linecolor: colour("axis"), zeroline: false, automargin: true };
  return { ...line, ticks: "outside", tickcolor: colour("axis"), ticklen: 4, ...axis };
}

/** Draws, or draws again. What people zoomed into stays as long as `shown` is the same. */
export function draw(id, description, traces, { x, y, shown = "", annotations = [] }) {
  const node = document.getElementById(id);
  node.setAttribute("role", "img");
  node.setAttribute("aria-label", description);
  Plotly.react(
    node,
    traces,
    {
      xaxis: styled(x),
      yaxis: styled(y),
      annotations,
      margin: { l: 16, r: 12, t: 8, b: 16 },
      showlegend: false,
      hovermode: "closest",
      hoverlabel: { bgcolor: colour("paper"), bordercolor: colour("axis"), font: { color: colour("ink") } },
      paper_bgcolor: "rgba(0,0,0,0)",
      plot_bgcolor: "rgba(0,0,0,0)",
      font: { family: "system-ui, sans-serif", size: 12, color: colour("soft") },
      modebar: { bgcolor: "rgba(0,0,0,0)", color: colour("soft"), activecolor: colour("ink") },
      uirevision: shown,
    },
    config,
  );
}

/** The region between two curves over the same x, as two traces. */
export function band(x, lower, upper, fillcolor) {
  const common = { x, mode: "lines", line: { width: 0 }, hoverinfo: "skip" };
  return [
    { ...common, y: lower, meta: "lower" },
    { ...common, y: upper, fill: "tonexty", fillcolor, meta: "upper" },
  ];
}
