// From values to colours: a perceptual scale for values (viridis), one with a pale middle for errors (ColorBrewer's
// PuOr, which colour-blind people can read).

const hex = (text) => [0, 2, 4].map((at) => parseInt(text.slice(at, at + 2), 16));
const viridis = ["440154", "482878", "3e4989", "31688e", "26828e", "1f9e89", "35b779", "6ece58", "b5de2b", "fde725"].map(hex);
const puOr = ["542788", "8073ac", "b2abd2", "d8daeb", "f7f7f7", "fee0b6", "fdb863", "e08214", "b35806"].map(hex);
const unknown = [128, 128, 128];
const steps = 256;

/** All colours of a scale, three bytes each. */
function tableOf(stops) {
  const table = new Uint8Array(3 * steps);
  for (let i = 0; i < steps; ++i) {
    const position = (i / (steps - 1)) * (stops.length - 1);
    const below = Math.min(Math.floor(position), stops.length - 2);
    for (let k = 0; k < 3; ++k)
      table[3 * i + k] = Math.round(stops[below][k] + (position - below) * (stops[below + 1][k] - stops[below][k]));
  }
  return table;
}

const tables = { values: tableOf(viridis), errors: tableOf(puOr) };

export const gradientOf = (kind) =>
  `linear-gradient(to right, ${(kind === "errors" ? puOr : viridis).map((c) => `rgb(${c})`).join(",")})`;

/** The finite values between which 98 of 100 lie. */
function middle(...lists) {
  const all = new Float32Array(lists.reduce((sum, { length }) => sum + length, 0));
  let count = 0;
  for (const list of lists) for (const value of list) if (Number.isFinite(value)) all[count++] = value;
  if (!count) return [0, 0];
  const sorted = all.subarray(0, count).sort();
  const at = (part) => sorted[Math.round(part * (count - 1))];
  return [at(0.01), at(0.99)];
}

/** For values: what all the lists spread over, such as estimates and truth, so that their colours can be compared. */
export function valueRange(...lists) {
  const [low, high] = middle(...lists);
  return low < high ? [low, high] : [low - Math.abs(low || 1) / 2, high + Math.abs(high || 1) / 2];
}

/** For errors: symmetric around zero. */
export function errorRange(errors) {
  const [low, high] = middle(errors);
  const end = Math.max(-low, high) || 1;
  return [-end, end];
}

/** Three bytes a value; beyond the range, the colour of its end. */
export function coloursOf(values, [low, high], kind) {
  const table = tables[kind];
  const colours = new Uint8Array(3 * values.length);
  const scale = (steps - 1) / (high - low);
  for (let i = 0; i < values.length; ++i) {
    const value = values[i];
    if (Number.isNaN(value)) {
      colours.set(unknown, 3 * i);
      continue;
    }
    const step = 3 * Math.round(Math.min(steps - 1, Math.max(0, (value - low) * scale)));
    colours[3 * i] = table[step];
    colours[3 * i + 1] = table[step + 1];
    colours[3 * i + 2] = table[step + 2];
  }
  return colours;
}
