// Which claims a wish keeps, against small claims whose answers are plain.
import assert from "node:assert/strict";
import { test } from "node:test";
import { choices, counts, matches, noWish, scoreText, sizesText } from "../src/ledger/filter.ts";
import type { Claim, Finding } from "../src/report.ts";

const none = { killed: 0, survived: 0, equivalent: 0 };

function finding(engine: string): Finding {
  return { engine, status: "Proved", sizes: [], trials: 1, discards: 0, error_log2: null, detail: "", survivors: [], seconds: 0 };
}

function claim(change: Partial<Claim>): Claim {
  return {
    id: "FJ07.16",
    paper: "FJ07",
    source: "equation (16)",
    title: "every ruling by differences",
    statement: "$d_N-c_N$",
    status: "Proved",
    engine: "symbolic",
    sizes: [],
    error_log2: null,
    hypotheses: [{ words: "M* is no knot", stated: false }],
    as_printed: false,
    remark: "",
    coq: null,
    mutants: none,
    faults: none,
    seed: 1,
    seconds: 0,
    engines: [finding("symbolic"), finding("modular")],
    ...change,
  };
}

test("no wish keeps every claim", () => {
  assert.equal(matches(claim({}), noWish), true);
  assert.equal(matches(claim({ paper: "ZW06", status: "Refuted", as_printed: true, engines: [] }), noWish), true);
});

test("paper, status and engine must be the chosen ones", () => {
  assert.equal(matches(claim({}), { ...noWish, paper: "FJ07", status: "Proved", engine: "modular" }), true);
  assert.equal(matches(claim({}), { ...noWish, paper: "FJ0" }), false);
  assert.equal(matches(claim({}), { ...noWish, status: "Refuted" }), false);
  assert.equal(matches(claim({}), { ...noWish, engine: "ball" }), false);
});

test("every word must occur somewhere, in any case", () => {
  assert.equal(matches(claim({}), { ...noWish, text: "  RULING  knot " }), true);
  assert.equal(matches(claim({}), { ...noWish, text: "d_n-c_n" }), true);
  assert.equal(matches(claim({}), { ...noWish, text: "ruling cone" }), false);
  assert.equal(matches(claim({ remark: "holds for a cone too" }), { ...noWish, text: "ruling cone" }), true);
});

test("unstated hypotheses", () => {
  assert.equal(matches(claim({}), { ...noWish, unstated: true }), true);
  assert.equal(matches(claim({ as_printed: true }), { ...noWish, unstated: true }), false);
});

test("choices are distinct, counts add up", () => {
  assert.deepEqual(choices(["b", "a", "b"]), ["b", "a"]);
  assert.deepEqual([...counts(["b", "a", "b"])], [["b", 2], ["a", 1]]);
});

test("sizes in words", () => {
  const grid = (low: number, high: number, pieces: number) => {
    const sizes: [number, number][] = [];
    for (let n = low; n <= high; ++n) for (let k = 1; k <= pieces; ++k) sizes.push([n, k]);
    return sizes;
  };
  assert.equal(sizesText([]), "–");
  assert.equal(sizesText(grid(1, 4, 4)), "n ≤ 4, N ≤ 4");
  assert.equal(sizesText(grid(2, 4, 1)), "2 ≤ n ≤ 4, N = 1");
  assert.equal(sizesText(grid(3, 3, 2)), "n = 3, N ≤ 2");
  assert.equal(sizesText([[2, 1], [2, 3]]), "n = 2, N ≤ 3 (2 sizes)");
});

test("scores in words", () => {
  assert.equal(scoreText({ killed: 3, survived: 1, equivalent: 9 }), "3 of 4");
  assert.equal(scoreText(none), "–");
});
