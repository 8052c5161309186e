// Who made the numbers, with what, when.

import { byId, element } from "./elements.js";

const plain = (value) => {
  if (value === true) return "yes";
  if (value === false) return "no";
  if (value !== null && typeof value === "object")
    return Object.entries(value)
      .map(([key, inner]) => `${key} ${plain(inner)}`)
      .join(", ");
  return String(value);
};

const titles = { dirty: "sources modified", build_type: "build type", cpu: "processor", os: "system" };

function studyProvenance(study) {
  const seed = "seed" in study ? { seed: study.seed } : {}; // nothing is random in a study of detail
  const entries = { folder: study.folder, ...seed, ...study.provenance };
  const terms = Object.entries(entries).flatMap(([key, value]) => [
    element("dt", {}, titles[key] ?? key),
    element("dd", {}, plain(value)),
  ]);
  const source = element("details", {}, element("summary", {}, "The study’s file"));
  source.append(element("pre", { tabindex: "0" }, JSON.stringify(study.study, null, 2)));
  return element("article", {}, element("h3", {}, study.study.name), element("dl", {}, ...terms), source);
}

export function showProvenance(studies) {
  byId("provenances").replaceChildren(...studies.map(studyProvenance));
}
