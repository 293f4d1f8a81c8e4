// How statements are cut into words and formulas.
import assert from "node:assert/strict";
import { test } from "node:test";
import { parse } from "../src/statement.ts";

const math = (text: string) => ({ math: true, text });
const words = (text: string) => ({ math: false, text });

test("words with formulas between dollar signs", () => {
  assert.deepEqual(parse("For $a=b$ and $c$."), [[words("For "), math("a=b"), words(" and "), math("c"), words(".")]]);
  assert.deepEqual(parse("$a$"), [[math("a")]]);
});

test("a dollar sign within braces belongs to the formula", () => {
  assert.deepEqual(parse("\\text{each $d$-fold }x"), [[math("\\text{each $d$-fold }x")]]);
});

test("a line for each quad outside of braces", () => {
  assert.deepEqual(parse("a=b,\\quad c=d\\qquad\ne"), [[math("a=b,")], [math("c=d")], [math("e")]]);
  assert.deepEqual(parse("{a\\quad b}\\quadratic"), [[math("{a\\quad b}\\quadratic")]]);
});

test("escaped braces are no braces", () => {
  assert.deepEqual(parse("\\{a\\quad b\\}"), [[math("\\{a")], [math("b\\}")]]);
});
