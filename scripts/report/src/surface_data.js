// The numbers of a surface, from the base64 texts that the program wrote; decoded once, when first shown.

function bytesOf(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes.buffer;
}

const floatsByQuantity = (texts) =>
  Object.fromEntries(Object.entries(texts).map(([quantity, text]) => [quantity, new Float32Array(bytesOf(text))]));

export function decodeSurface(arrays) {
  return {
    cells: new Uint16Array(bytesOf(arrays.cells)),
    signs: new Int8Array(bytesOf(arrays.signs)),
    truth: floatsByQuantity(arrays.truth),
    estimates: arrays.estimates.map(floatsByQuantity),
    directions: arrays.directions.map((text) => text && new Int8Array(bytesOf(text))),
  };
}

/** What a surface can be coloured by: estimate, truth, or estimate minus truth (NaN where there is no truth). */
export function valuesOf(surface, estimator, quantity, kind) {
  const estimate = surface.estimates[estimator][quantity];
  const truth = surface.truth[quantity];
  if (kind === "estimate") return estimate;
  return kind === "truth" ? truth : estimate.map((value, i) => value - truth[i]);
}
