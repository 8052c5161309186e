// The page: reads the data that the program put into it, and shows them.

import { showCurves } from "./curve_list.js";
import { curvesOf, entryOf, fallbackShare } from "./curves.js";
import { byId } from "./elements.js";
import { drawErrors } from "./errors_chart.js";
import { showProvenance } from "./provenance.js";
import { drawScan } from "./scan_chart.js";
import { Selection } from "./selection.js";
import { SlopeTable } from "./slope_table.js";
import { startSurfaceView } from "./surface_view.js";
import { startTheme } from "./theme.js";
import { drawTime } from "./time_chart.js";
import { drawWork } from "./work_chart.js";

const { studies } = JSON.parse(byId("report-data").textContent);
const curves = curvesOf(studies);
const selection = new Selection(curves);
const table = new SlopeTable();

const names = [...new Set(studies.map(({ study }) => study.name))];
byId("title").textContent = names.join(", ");
document.title = `${names.join(", ")} – Gridstep`;
byId("subtitle").textContent = studies.length === 1 ? (studies[0].study.description ?? "") : `${studies.length} studies side by side`;

function showTable() {
  const everything = byId("everything").checked;
  const row = (curve, entry) => ({ ...entry, study: curve.study, fallbacks: fallbackShare(curve, entry.levels.at(-1).h) });
  const series = everything
    ? curves.flatMap((curve) => curve.convergence.map((entry) => row(curve, entry)))
    : selection.curves.map((curve) => row(curve, entryOf(curve.convergence, selection)));
  table.show(series);
}

function show() {
  showCurves(selection);
  drawErrors(selection);
  drawScan(selection);
  drawWork(selection);
  drawTime(selection);
  showTable();
}

selection.onChange(show);
byId("everything").addEventListener("change", showTable);
startTheme(show);
show();
showProvenance(studies);
startSurfaceView(studies);
