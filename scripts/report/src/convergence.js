// Error curves, slopes, times and their table: what the form at the top asks for.

import { showCurves } from "./curve_list.js";
import { curvesOf, entryOf, fallbackShare } from "./curves.js";
import { byId } from "./elements.js";
import { drawErrors } from "./errors_chart.js";
import { drawScan } from "./scan_chart.js";
import { Selection } from "./selection.js";
import { SlopeTable } from "./slope_table.js";
import { drawTime } from "./time_chart.js";
import { drawWork } from "./work_chart.js";

/** Shows the curves of these studies, or hides all that is about curves where there are none. Returns what draws them
 *  again. */
export function startConvergence(studies) {
  byId("convergence").hidden = !studies.length;
  if (!studies.length) return () => {};
  const curves = curvesOf(studies);
  const selection = new Selection(curves);
  const table = new SlopeTable();

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
  show();
  return show;
}
