// Principal directions as crosses on the surface: black along k1, the larger curvature, white along k2. As many as
// can be told apart: one surfel of each cube of a grid has one.

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";
import { extentOf } from "./surface_geometry.js";

const crossesAlong = 30; // cubes along the surface's diameter

/** Which surfels of a surface have a cross, and how large it is: the same for all that is estimated on it. */
export function crossesOf({ cells }) {
  const { middle, radius } = extentOf(cells);
  const cube = Math.max(4, (2 * radius) / crossesAlong);
  const chosen = new Map();
  for (let i = 0; i < cells.length; i += 3) {
    const key = [0, 1, 2].map((k) => Math.floor(cells[i + k] / cube)).join();
    if (!chosen.has(key)) chosen.set(key, i / 3);
  }
  return { middle, cube, surfels: [...chosen.values()] };
}

export class DirectionLines {
  constructor(surface, { middle, cube, surfels }, directions) {
    const positions = new Float32Array(12 * surfels.length);
    const colours = new Uint8Array(16 * surfels.length).fill(255);
    surfels.forEach((surfel, i) => {
      for (const [number, ink] of [[0, 0], [1, 255]]) { // prettier-ignore
        for (const [end, way] of [-1, 1].entries()) {
          const vertex = 4 * i + 2 * number + end;
          colours.fill(ink, 4 * vertex, 4 * vertex + 3);
          for (let k = 0; k < 3; ++k) {
            const coordinate = surface.cells[3 * surfel + k];
            const lifted = coordinate % 2 === 0 ? 1.5 * surface.signs[surfel] : 0;
            const along = directions[6 * surfel + 3 * number + k] / 127;
            positions[3 * vertex + k] = coordinate - middle[k] + lifted + way * 0.36 * cube * along;
          }
        }
      }
    });
    this.#geometry.setAttribute("position", new BufferAttribute(positions, 3));
    this.#geometry.setAttribute("color", new BufferAttribute(colours, 4, true));
    this.object = new LineSegments(this.#geometry, this.#material);
  }

  #geometry = new BufferGeometry();
  #material = new LineBasicMaterial({ vertexColors: true });

  dispose() {
    this.#geometry.dispose();
    this.#material.dispose();
  }
}
