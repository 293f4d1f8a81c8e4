// Geometry and colours of pictures, on small pictures whose answers are plain.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Picture, State } from "../src/report.ts";
import { lightness, warpColour } from "../src/scene/colour.ts";
import { axes, box, edgeRuns, lines, netLines, sideView, singularLines, strip } from "../src/scene/shape.ts";

function state(change: Partial<State> = {}): State {
  const t = [0, 0.5, 1];
  const rulings = t.map((x) => [x, 0, 0, x, 1, 0]);
  return { label: "surface", t, targets: t, rulings, warp: [0, 5, 10], ...change };
}

function picture(change: Partial<Picture> = {}): Picture {
  return { name: "x", size: "1", net: null, states: [state()], singular: [], ...change };
}

test("colours get lighter with the warp, by steps that look alike", () => {
  const values = Array.from({ length: 25 }, (_, i) => lightness(warpColour(i / 24)));
  for (let i = 1; i < values.length; ++i) {
    const step = (values[i] as number) - (values[i - 1] as number);
    assert.ok(step > 1 && step < 6, `step ${i}: ${step}`);
  }
  assert.deepEqual(warpColour(-1), warpColour(0));
  assert.deepEqual(warpColour(2), warpColour(1));
});

test("lightness is that of CIELAB", () => {
  assert.equal(lightness([0, 0, 0]), 0);
  assert.ok(Math.abs(lightness([1, 1, 1]) - 100) < 1e-9);
  assert.ok(Math.abs(lightness([0.5, 0.5, 0.5]) - 53.389) < 1e-2);
});

test("a strip has two triangles between neighbours, and its colours are those of the warp", () => {
  const shape = strip(state(), 10);
  assert.equal(shape.positions.length, 18);
  assert.deepEqual(shape.triangles, [0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4]);
  assert.deepEqual(shape.colours.slice(12, 15), warpColour(1));
  const flat = strip(state({ warp: [0, 1e-9, 0] }), 1e-9).colours;
  assert.deepEqual(flat.slice(0, 3), flat.slice(6, 9));
});

test("a gap breaks the strip", () => {
  const rulings = state().rulings;
  assert.deepEqual(strip(state({ rulings: [rulings[0] ?? null, null, rulings[2] ?? null] }), 10).triangles, []);
});

test("rulings are drawn from the first to the last", () => {
  const many = Array.from({ length: 101 }, (_, i) => [i, 0, 0, i, 1, 0]);
  const drawn = lines(state({ rulings: many }), 40);
  assert.equal(drawn[0], 0);
  assert.equal(drawn[drawn.length - 3], 100);
  assert.ok(drawn.length / 6 >= 34 && drawn.length / 6 <= 52);
});

test("the edge stops where it is far away", () => {
  const runs = edgeRuns(state({ edge: [-1, null, 50] }));
  assert.deepEqual(runs, [[[0, -1, 0]]]);
  assert.deepEqual(edgeRuns(state({ edge: [0.5, 2, 3] })), [[[0, 0.5, 0], [0.5, 2, 0], [1, 3, 0]]]);
  assert.deepEqual(edgeRuns(state()), []);
});

test("the edge goes as far beyond one rail as beyond the other", () => {
  assert.deepEqual(edgeRuns(state({ edge: [3.4, 3.6, 3.4] })), [[[0, 3.4, 0]], [[1, 3.4, 0]]]);
  assert.deepEqual(edgeRuns(state({ edge: [-2.4, -2.6, -2.4] })), [[[0, -2.4, 0]], [[1, -2.4, 0]]]);
});

test("singular rulings are those in the range, or the nearest", () => {
  const at = (from: number, to: number) => singularLines(picture({ singular: [{ reason: "edge", from, to }] }));
  assert.deepEqual(at(0.4, 1), [...(state().rulings[1] ?? []), ...(state().rulings[2] ?? [])]);
  assert.deepEqual(at(0.5, 1), at(0.4, 1));
  assert.deepEqual(at(0, 0.5), [...(state().rulings[0] ?? []), ...(state().rulings[1] ?? [])]);
  assert.deepEqual(at(0.2, 0.2), state().rulings[0]);
  assert.deepEqual(at(0.3, 0.3), state().rulings[1]);
});

test("a net joins its points in pairs", () => {
  const net = netLines({ degree: 1, knots: [0, 1], c: { points: [0, 0, 0, 1, 0, 0], weights: [1, 1] }, d: { points: [0, 0, 1, 1, 0, 1], weights: [1, 1] } });
  assert.deepEqual(net.c, [[0, 0, 0], [1, 0, 0]]);
  assert.deepEqual(net.between, [0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1]);
});

test("axes are eigenvectors, the least first", () => {
  const matrix = [[4, 1, 0.5], [1, 3, -0.25], [0.5, -0.25, 7]];
  const values = axes(matrix).map((v) => {
    const image = matrix.map((row) => row.reduce((sum, x, k) => sum + x * (v[k] as number), 0));
    const value = image.reduce((sum, x, k) => sum + x * (v[k] as number), 0);
    image.forEach((x, k) => assert.ok(Math.abs(x - value * (v[k] as number)) < 1e-10));
    return value;
  });
  assert.ok((values[0] as number) < (values[1] as number) && (values[1] as number) < (values[2] as number));
  assert.ok(Math.abs(values.reduce((sum, value) => sum + value, 0) - 14) < 1e-10);
});

test("a flat strip is seen from above", () => {
  const view = sideView(picture());
  assert.ok(view[2] > 0.9 * Math.hypot(...view));
});

test("the box holds a net that is not much larger", () => {
  const row = (y: number) => ({ points: [0, y, 0, 1, y, 0], weights: [1, 1] });
  const net = (y: number) => ({ degree: 1, knots: [0, 1], c: row(-y), d: row(1 + y) });
  assert.deepEqual(box(picture({ net: net(0.5) })), { middle: [0.5, 0.5, 0], radius: Math.sqrt(5) / 2 });
  assert.equal(box(picture({ net: net(50) })).radius, Math.SQRT2 / 2);
});

test("the box holds all states; nothing to draw is no error", () => {
  const far = state({ rulings: [[0, 0, 0, 0, 0, 3]] });
  const { middle, radius } = box(picture({ states: [state(), far] }));
  assert.deepEqual(middle, [0.5, 0.5, 1.5]);
  assert.ok(Math.abs(radius - Math.sqrt(11) / 2) < 1e-12);
  assert.deepEqual(box(picture({ states: [state({ rulings: [null, null, null] })] })), { middle: [0, 0, 0], radius: 1 });
});
