// A curve is what stays the same along a schedule, in one study: shape, noise, estimator, radius. It has errors by
// quantity and norm, costs by evaluation, and points of work and precision.

import { radiusText } from "./text.js";

const settingKeys = ["shape", "noise", "rotated", "estimator", "centre", "k", "alpha"];

/** All curves of the report, in the order of the studies. */
export function curvesOf(studies) {
  const curves = new Map();
  studies.forEach((study, number) => {
    const curveOf = (entry) => {
      const key = JSON.stringify([number, ...settingKeys.map((name) => entry[name])]);
      if (!curves.has(key)) {
        const setting = Object.fromEntries(settingKeys.map((name) => [name, entry[name]]));
        curves.set(key, { key, study: studyName(study, studies), ...setting, convergence: [], costs: [], work: [] });
      }
      return curves.get(key);
    };
    for (const series of study.convergence) curveOf(series).convergence.push(series);
    for (const cost of study.cost) curveOf(cost).costs.push(cost);
    for (const points of study.work_precision) curveOf(points).work.push(points);
  });
  return [...curves.values()];
}

/** The study's name, with its folder where others have the same name. */
export function studyName(study, studies) {
  const { name } = study.study;
  return studies.filter((other) => other.study.name === name).length > 1 ? `${name} (${study.folder})` : name;
}

/** The series or points of a curve in a quantity and norm, if it has them. */
export function entryOf(entries, { quantity, norm }) {
  return entries.find((entry) => entry.quantity === quantity && entry.norm === norm);
}

/** The share of the surfels at which a guard took another kernel, at h. */
export function fallbackShare(curve, h) {
  const step = curve.costs.flatMap(({ steps }) => steps).find((other) => other.h === h);
  return step?.fallbacks ? step.fallbacks / step.surfels : 0;
}

const shapeName = (shape) => shape.split(":")[0];

const parts = [
  (curve) => curve.study,
  (curve, curves) => {
    const specs = new Set(curves.map(({ shape }) => shape).filter((s) => shapeName(s) === shapeName(curve.shape)));
    return specs.size > 1 ? curve.shape : shapeName(curve.shape);
  },
  (curve) => curve.estimator,
  radiusText,
  (curve) => (curve.centre === "surfel" ? "kernels centred on surfels" : ""),
  (curve) => (curve.noise > 0 ? `noise ${curve.noise}` : "no noise"),
  (curve) => (curve.rotated ? "rotated" : ""),
];

/** What tells each curve from the others of a list; what all have in common is left out. */
export function labelsOf(curves) {
  const differing = parts.filter((part) => new Set(curves.map((curve) => part(curve, curves))).size > 1);
  const used = differing.length ? differing : [parts[1], parts[2]];
  return curves.map((curve) => used.map((part) => part(curve, curves)).filter(Boolean).join(", "));
}
