// Numbers and names as people read them.

const minus = (text) => text.replace(/-/g, "−");

/** Four significant digits: 0.01230, 12.35, 1.235e−5. */
export function errorText(value) {
  if (!Number.isFinite(value)) return "–";
  const plain = value === 0 || (Math.abs(value) >= 1e-4 && Math.abs(value) < 1e6);
  return minus(plain ? value.toPrecision(4) : value.toExponential(3));
}

/** Three decimals. */
export function slopeText(value) {
  return Number.isFinite(value) ? minus(value.toFixed(3)) : "–";
}

/** [0.310, 0.352]; ends that are null have none. */
export function intervalText([lower, upper]) {
  return lower === null || upper === null ? "–" : `[${slopeText(lower)}, ${slopeText(upper)}]`;
}

export function exponentText(value) {
  return Number.isFinite(value) ? minus(value.toFixed(2)) : "–";
}

/** h to four digits, without trailing zeros. */
export function stepText(h) {
  return String(Number(h.toPrecision(4)));
}

export function countText(count) {
  return count.toLocaleString("en").replaceAll(",", "\u202f");
}

/** h^(1/3) for the common exponent, h^0.4 for others. */
export function powerText(alpha) {
  return Math.abs(alpha - 1 / 3) < 1e-9 ? "h^(1/3)" : `h^${Number(alpha.toPrecision(3))}`;
}

/** R = k h^alpha, or nothing for an estimator without a radius. */
export function radiusText({ k, alpha }) {
  return k === null ? "" : `R = ${Number(k.toPrecision(4))} ${powerText(alpha)}`;
}

/** R = 3.5, 14 voxels: of a ball given in cells of edge h. */
export function digitalRadiusText({ digital_radius }, h) {
  const voxels = `${Number(digital_radius.toPrecision(4))} voxels`;
  return h === 1 ? `R = ${voxels}` : `R = ${Number((digital_radius * h).toPrecision(4))}, ${voxels}`;
}

const quantityNames = {
  kappa: "curvature κ",
  mean: "mean curvature H",
  gaussian: "Gaussian curvature K",
  k1: "principal curvature κ₁",
  k2: "principal curvature κ₂",
  tangent: "tangent (angle)",
  normal: "normal (angle)",
};

export function quantityText(quantity) {
  return quantityNames[quantity] ?? quantity;
}
