// The page: reads the data that the program put into it, and shows them.

import { startConvergence } from "./convergence.js";
import { byId } from "./elements.js";
import { showProvenance } from "./provenance.js";
import { showRadii } from "./radius_table.js";
import { startSurfaceView } from "./surface_view.js";
import { startTheme } from "./theme.js";

const { studies } = JSON.parse(byId("report-data").textContent);
const ofRadii = ({ detail }) => detail !== undefined; // one surface at several radii: values, where others have errors

const names = [...new Set(studies.map(({ study }) => study.name))];
byId("title").textContent = names.join(", ");
document.title = `${names.join(", ")} – Gridstep`;
byId("subtitle").textContent = studies.length === 1 ? (studies[0].study.description ?? "") : `${studies.length} studies side by side`;

startTheme(startConvergence(studies.filter((study) => !ofRadii(study))));
showRadii(studies.filter(ofRadii));
showProvenance(studies);
startSurfaceView(studies);
for (const link of document.querySelectorAll("nav a")) link.hidden = byId(link.hash.slice(1)).closest("[hidden]") !== null;
