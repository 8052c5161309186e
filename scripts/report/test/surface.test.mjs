// The geometry against one quad a surfel, and what is drawn against what faces the eye.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Vector3 } from "three";
import { rectanglesOf } from "../src/rectangles.js";
import { SurfaceColours } from "../src/surface_colours.js";
import { SurfaceGeometry } from "../src/surface_geometry.js";
import { SurfelPicture } from "../src/surfel_picture.js";

/** Boundary of the points of a small cube that satisfy a predicate, as the program writes it. */
function boundary(inside, size) {
  const cells = [];
  const signs = [];
  let points = 0;
  const has = (z) => z.every((c) => c >= 0 && c < size) && inside(...z);
  for (let x = 0; x < size; ++x)
    for (let y = 0; y < size; ++y)
      for (let z = 0; z < size; ++z) {
        if (!has([x, y, z])) continue;
        ++points;
        for (let axis = 0; axis < 3; ++axis)
          for (const sign of [1, -1]) {
            const outer = [x, y, z];
            outer[axis] += sign;
            if (has(outer)) continue;
            const cell = [2 * x + 3, 2 * y + 3, 2 * z + 3];
            cell[axis] += sign;
            cells.push(...cell);
            signs.push(sign);
          }
      }
  return { points, cells: Uint16Array.from(cells), signs: Int8Array.from(signs) };
}

const ball = boundary((x, y, z) => Math.hypot(x - 9.3, y - 9.1, z - 8.7) < 8, 20);
const ring = boundary((x, y, z) => Math.hypot(Math.hypot(x - 10, y - 10) - 6, z - 4) < 3, 20);

for (const [name, surface] of Object.entries({ ball, ring })) {
  test(`${name}: every surfel is in one rectangle, at its place`, () => {
    const seen = new Set();
    let count = 0;
    for (const { axis, sign, rectangles } of rectanglesOf(surface)) {
      let last = -Infinity;
      for (const { width, surfels } of rectangles) {
        const at = (surfel, k) => surface.cells[3 * surfel + (k % 3)];
        assert.equal(surfels.length % width, 0);
        assert.ok(at(surfels[0], axis) >= last, "sorted along the axis");
        last = at(surfels[0], axis);
        surfels.forEach((surfel, i) => {
          assert.ok(!seen.has(surfel));
          seen.add(surfel);
          assert.equal(surface.signs[surfel], sign);
          assert.equal(at(surfel, axis), last);
          assert.equal(at(surfel, axis + 1), at(surfels[0], axis + 1) + 2 * (i % width));
          assert.equal(at(surfel, axis + 2), at(surfels[0], axis + 2) + 2 * Math.floor(i / width));
        });
        ++count;
      }
    }
    assert.equal(seen.size, surface.signs.length);
    assert.ok(count < surface.signs.length / 2, `${count} rectangles of ${seen.size} surfels`);
  });

  test(`${name}: triangles look outwards, and enclose the volume`, () => {
    const [{ buffer }] = new SurfaceGeometry(surface).parts;
    const { position, rectangle } = buffer.attributes;
    const index = buffer.index.array;
    const corner = (i) => new Vector3().fromBufferAttribute(position, index[i]);
    let threefold = 0; // divergence theorem: the flux of x
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
      const normal = b.clone().sub(a).cross(c.clone().sub(a));
      const area = 2 * rectangle.getY(index[i]) * rectangle.getZ(index[i]); // of a half
      assert.ok(Math.abs(normal.length() / 2 - area) < 0.05 * area, "half a rectangle, but for the overlap");
      threefold += area * a.dot(normal.normalize());
    }
    assert.ok(Math.abs(threefold - 3 * 8 * surface.points) < 1e-6 * threefold, `${threefold / 24} for ${surface.points} points`);
  });

  test(`${name}: what is drawn is what faces the eye`, () => {
    const geometry = new SurfaceGeometry(surface);
    for (const eye of [[40.3, 30.3, 50.3], [-60.3, 1.3, 2.3], [1.3, 3.3, 2.3], [0.3, -25.3, 9.3]].map((place) => new Vector3(...place))) {
      geometry.faceEye(eye);
      const drawn = new Set();
      for (const { buffer } of geometry.parts)
        for (let i = 0; i < buffer.drawRange.count; i += 6) drawn.add((buffer.drawRange.start + i) / 6);
      const [{ buffer }] = geometry.parts;
      const { position } = buffer.attributes;
      const index = buffer.index.array;
      const corner = (i) => new Vector3().fromBufferAttribute(position, index[i]);
      for (let i = 0; i < index.length; i += 6) {
        const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
        const faces = b.clone().sub(a).cross(c.clone().sub(a)).dot(eye.clone().sub(a)) > 0;
        assert.equal(drawn.has(i / 6), faces, `rectangle ${i / 6} from ${eye.toArray()}`);
      }
    }
  });
}

test("new colours leave the geometry alone, and reach each surfel's texel", () => {
  const picture = new SurfelPicture(new SurfaceGeometry(ball));
  const coloured = new SurfaceColours(picture);
  const [{ buffer: geometry }] = picture.geometry.parts;
  const versions = () => [geometry.index, ...Object.values(geometry.attributes)].map(({ version }) => version);
  const before = versions();
  const colours = new Uint8Array(3 * ball.signs.length);
  ball.signs.forEach((_, surfel) => colours.set([surfel % 251, surfel >> 8, 7], 3 * surfel));
  coloured.colour(colours);
  assert.deepEqual(versions(), before);
  const texels = coloured.object.material.uniforms.colours.value.image.data;
  const { rectangle } = geometry.attributes;
  let number = 0;
  for (const { rectangles } of rectanglesOf(ball))
    for (const { width, surfels } of rectangles) {
      for (let vertex = 4 * number; vertex < 4 * number + 4; ++vertex)
        assert.deepEqual([rectangle.getY(vertex), rectangle.getZ(vertex)], [width, surfels.length / width]);
      surfels.forEach((surfel, i) => {
        const texel = rectangle.getX(4 * number) + i; // as the shader finds it
        assert.deepEqual([...texels.slice(4 * texel, 4 * texel + 3)], [surfel % 251, surfel >> 8, 7]);
      });
      ++number;
    }
});

test("colours of one picture are their own, and share all else", () => {
  const picture = new SurfelPicture(new SurfaceGeometry(ball));
  const [red, blue] = [new SurfaceColours(picture), new SurfaceColours(picture)];
  const colours = (colour) => Uint8Array.from({ length: 3 * ball.signs.length }, (_, i) => colour[i % 3]);
  red.colour(colours([255, 0, 0]));
  blue.colour(colours([0, 0, 255]));
  const uniforms = ({ object }) => object.material.uniforms;
  const first = (coloured) => [...uniforms(coloured).colours.value.image.data.slice(0, 3)];
  assert.deepEqual([first(red), first(blue)], [[255, 0, 0], [0, 0, 255]]);
  for (const name of ["surfels", "depths"]) assert.equal(uniforms(red)[name].value, uniforms(blue)[name].value);
  let disposed = false;
  picture.geometry.parts[0].buffer.addEventListener("dispose", () => (disposed = true));
  red.dispose();
  assert.ok(!disposed, "the other one still shows it");
  picture.dispose();
  assert.ok(disposed);
});
