// What plots show and say, on small data.
import assert from "node:assert/strict";
import { test } from "node:test";
import { description, lookOf, shown, thinned } from "../src/plots.ts";
import type { PlotData } from "../src/report.ts";

const data: PlotData = {
  title: "Errors",
  x: { label: "pieces" },
  y: { label: "error / u", log: true },
  series: [
    { name: "a", points: [[1, 0.5], [2, 0], [4, 8]] },
    { name: "b", points: [[1, -1]] },
  ],
};

test("a logarithmic axis leaves out what is not positive", () => {
  assert.deepEqual(shown(data).map((series) => series.points), [[[1, 0.5], [4, 8]], []]);
  assert.deepEqual(shown({ ...data, y: { label: "y" } }).map((series) => series.points.length), [3, 1]);
});

test("words for those who do not see the plot", () => {
  assert.equal(description(data), "Errors: error / u by pieces. a: 2 points, from 0.5000 to 8; b: no points.");
});

test("thinning keeps both ends and the order", () => {
  const list = Array.from({ length: 1000 }, (_, i) => i);
  const kept = thinned(list, 7);
  assert.equal(kept.length, 7);
  assert.deepEqual([kept[0], kept[6]], [0, 999]);
  assert.deepEqual([...kept].sort((a, b) => a - b), kept);
  assert.deepEqual(thinned([1, 2], 7), [1, 2]);
});

test("18 lines look different", () => {
  const looks = new Set(Array.from({ length: 18 }, (_, i) => JSON.stringify(lookOf(i))));
  assert.equal(looks.size, 18);
});
