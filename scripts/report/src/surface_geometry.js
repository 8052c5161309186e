// The shape of a digital surface, for all that is drawn on it: rectangles of surfels that lie in one plane, in six groups,
// by the axis and sign of their normals, each sorted along its axis. Those that face the eye are one range of each group,
// about half of all, and nothing else is drawn.

import { BufferAttribute, BufferGeometry } from "three";
import { rectanglesOf } from "./rectangles.js";

// Rectangles overlap by this part of half a cell: where a corner lies on another one's edge, rounding would leave holes.
const overlap = 0.02;

/** The middle of the cells, and how far the farthest is from it. */
export function extentOf(cells) {
  const least = [Infinity, Infinity, Infinity];
  const greatest = [-Infinity, -Infinity, -Infinity];
  cells.forEach((coordinate, i) => {
    least[i % 3] = Math.min(least[i % 3], coordinate);
    greatest[i % 3] = Math.max(greatest[i % 3], coordinate);
  });
  const middle = least.map((low, k) => (low + greatest[k]) / 2);
  let radius = 0;
  for (let i = 0; i < cells.length; i += 3)
    radius = Math.max(radius, Math.hypot(cells[i] - middle[0], cells[i + 1] - middle[1], cells[i + 2] - middle[2]));
  return { middle, radius };
}

/** The buffers of all rectangles, in units of half a cell around `middle`: four corners each, counter-clockwise seen
 *  from outside. */
function buffersOf(cells, groups, middle) {
  const count = groups.reduce((sum, { rectangles }) => sum + rectangles.length, 0);
  const position = new Float32Array(12 * count);
  const corner = new Float32Array(8 * count);
  const rectangle = new Float32Array(12 * count);
  const index = new Uint32Array(6 * count);
  let number = 0;
  let texel = 0;
  for (const { axis, sign, rectangles } of groups) {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    for (const { width, surfels } of rectangles) {
      const height = surfels.length / width;
      [0, 1, 2, 3].forEach((which) => {
        const vertex = 4 * number + which;
        const [right, up] = [which === 1 || which === 2 ? 1 : 0, which >= 2 ? 1 : 0];
        for (let k = 0; k < 3; ++k) position[3 * vertex + k] = cells[3 * surfels[0] + k] - middle[k];
        position[3 * vertex + u] += right ? 2 * width - 1 + overlap : -1 - overlap;
        position[3 * vertex + v] += up ? 2 * height - 1 + overlap : -1 - overlap;
        corner.set([right * width, up * height], 2 * vertex);
        rectangle.set([texel, width, height], 3 * vertex);
      });
      const turn = sign > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2];
      index.set(turn.map((which) => 4 * number + which), 6 * number); // prettier-ignore
      texel += surfels.length;
      ++number;
    }
  }
  return { position, corner, rectangle, index };
}

/** How many of the ascending numbers are below the limit. */
function countBelow(numbers, limit) {
  let [low, high] = [0, numbers.length];
  while (low < high) {
    const half = (low + high) >> 1;
    if (numbers[half] < limit) low = half + 1;
    else high = half;
  }
  return low;
}

export class SurfaceGeometry {
  #middle;
  #parts; // with where the rectangles of a group begin and their places along the axis

  constructor(surface) {
    const { cells } = surface;
    const { middle, radius } = extentOf(cells);
    this.#middle = middle;
    this.radius = radius;
    const groups = rectanglesOf(surface);
    /** The surfels in the order of the texels that their rectangles look up. */
    this.order = Uint32Array.from(groups.flatMap(({ rectangles }) => rectangles.flatMap(({ surfels }) => surfels)));

    const buffers = buffersOf(cells, groups, middle);
    const attributes = {
      position: new BufferAttribute(buffers.position, 3),
      corner: new BufferAttribute(buffers.corner, 2),
      rectangle: new BufferAttribute(buffers.rectangle, 3),
    };
    const index = new BufferAttribute(buffers.index, 1);
    let first = 0;
    this.#parts = groups.map(({ axis, sign, rectangles }) => {
      const buffer = new BufferGeometry().setIndex(index);
      for (const [name, attribute] of Object.entries(attributes)) buffer.setAttribute(name, attribute);
      const along = Uint16Array.from(rectangles, ({ surfels }) => cells[3 * surfels[0] + axis]);
      first += rectangles.length;
      return { axis, sign, buffer, along, first: first - rectangles.length };
    });
  }

  /** A buffer a group, and the axis of its normals. */
  get parts() {
    return this.#parts.map(({ axis, buffer }) => ({ axis, buffer }));
  }

  /** Draws no more than what faces an eye there. */
  faceEye(eye) {
    const coordinates = eye.toArray();
    for (const { axis, sign, buffer, along, first } of this.#parts) {
      const below = countBelow(along, coordinates[axis] + this.#middle[axis]);
      const [from, count] = sign > 0 ? [0, below] : [below, along.length - below];
      buffer.setDrawRange(6 * (first + from), 6 * count);
    }
  }

  dispose() {
    for (const { buffer } of this.#parts) buffer.dispose();
  }
}
