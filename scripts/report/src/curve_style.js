// Colour, symbol and dash of a curve, the same in every chart. Colours of Okabe and Ito, which colour-blind people
// tell apart; symbols differ too.

import { isDark } from "./theme.js";

const light = ["#0072b2", "#d55e00", "#009e73", "#aa4b84", "#b8860b", "#3f9bd4", "#5f6672"];
const dark = ["#56b4e9", "#e69f00", "#2fc79a", "#e39ac4", "#f0e442", "#ff8548", "#b3bac5"];
const symbols = ["circle", "square", "diamond", "triangle-up", "triangle-down", "cross", "x"];
const glyphs = ["●", "■", "◆", "▲", "▼", "✚", "✖"];

export function styleOf(number) {
  const n = light.length;
  const shape = (number + Math.floor(number / n)) % n; // the second round has other symbols
  return { colour: (isDark() ? dark : light)[number % n], symbol: symbols[shape], glyph: glyphs[shape] };
}

export function translucent(colour, opacity) {
  const [r, g, b] = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
  return `rgba(${r},${g},${b},${opacity})`;
}
