import assert from "node:assert/strict";
import { test } from "node:test";
import { coloursOf, errorRange, valueRange } from "../src/colour_scale.js";
import { labelsOf } from "../src/curves.js";
import { countText, digitalRadiusText, errorText, intervalText, powerText, radiusText, slopeText, stepText } from "../src/text.js";

test("numbers read as those of the program", () => {
  assert.equal(errorText(0.0123), "0.01230");
  assert.equal(errorText(-0.00001235), "−1.235e−5");
  assert.equal(slopeText(1 / 3), "0.333");
  assert.equal(intervalText([0.31, 0.352]), "[0.310, 0.352]");
  assert.equal(intervalText([null, null]), "–");
  assert.equal(stepText(0.0071177), "0.007118");
  assert.equal(powerText(1 / 3), "h^(1/3)");
  assert.equal(radiusText({ k: 5, alpha: 0.4 }), "R = 5 h^0.4");
  assert.equal(radiusText({ k: null, alpha: null }), "");
  assert.equal(digitalRadiusText({ digital_radius: 14 }, 1), "R = 14 voxels");
  assert.equal(digitalRadiusText({ digital_radius: 7.5 }, 0.1), "R = 0.75, 7.5 voxels");
  assert.equal(countText(195054), "195\u202f054");
});

test("labels tell curves apart, and say no more", () => {
  const curve = { study: "s", shape: "ellipse:a=2", estimator: "ii", k: 5, alpha: 0.4, centre: "spels", noise: 0, rotated: false };
  assert.deepEqual(labelsOf([curve]), ["ellipse, ii"]);
  assert.deepEqual(labelsOf([curve, { ...curve, shape: "disk:radius=1" }]), ["ellipse", "disk"]);
  assert.deepEqual(labelsOf([curve, { ...curve, shape: "ellipse:a=3" }]), ["ellipse:a=2", "ellipse:a=3"]);
  assert.deepEqual(labelsOf([curve, { ...curve, k: 3 }]), ["R = 5 h^0.4", "R = 3 h^0.4"]);
  assert.deepEqual(labelsOf([curve, { ...curve, noise: 0.3 }]), ["", "noise 0.3"].map((text) => text || "no noise"));
});

test("colours: ends beyond the range, grey where there is no value, the middle at no error", () => {
  const values = Float32Array.of(-10, 0, 10, NaN);
  const [range, errors] = [[-1, 1], coloursOf(values, [-1, 1], "errors")];
  assert.deepEqual([...errors.slice(0, 3)], [84, 39, 136]);
  assert.deepEqual([...errors.slice(6, 9)], [179, 88, 6]);
  assert.deepEqual([...errors.slice(9)], [128, 128, 128]);
  assert.ok(Math.min(...errors.slice(3, 6)) > 240, "pale");
  assert.deepEqual(errorRange(Float32Array.of(-2, 1, NaN)), range.map((end) => 2 * end));
  assert.deepEqual(valueRange(Float32Array.of(0, 1), Float32Array.of(3, NaN)), [0, 3]);
  const many = Float32Array.from({ length: 1000 }, (_, i) => i);
  assert.deepEqual(valueRange(many, many.map((x) => -x)), [-979, 979], "but for 1 % of all lists together at either end");
  const [low, high] = valueRange(Float32Array.of(2, 2), Float32Array.of(2));
  assert.ok(low < 2 && high > 2, "a range also where all values are equal");
});
