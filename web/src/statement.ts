// Statements of claims, typeset.
//   parse        a statement as lines of words and formulas        typeset     its element
import katex from "katex";
import { h } from "./dom.ts";

export interface Part {
  math: boolean;
  text: string;
}

/** Splits at `separator` outside of braces and \left..\right-free brackets. */
function splitOutside(text: string, separator: RegExp): string[] {
  const parts: string[] = [];
  let depth = 0;
  let begin = 0;
  for (let i = 0; i < text.length; ++i) {
    if (text[i] === "{") ++depth;
    if (text[i] === "}") --depth;
    separator.lastIndex = i;
    const match = depth === 0 ? separator.exec(text) : null;
    if (match !== null) {
      parts.push(text.slice(begin, i));
      begin = i + match[0].length;
      i = begin - 1;
    } else if (text[i] === "\\") {
      ++i;
    }
  }
  parts.push(text.slice(begin));
  return parts;
}

/** A statement is words with formulas between dollar signs, or, if it has no dollar sign outside of braces, one formula, a line for each \quad. */
export function parse(statement: string): Part[][] {
  const words = splitOutside(statement, /\$/y);
  if (words.length > 1) {
    const parts = words.map((text, i) => ({ math: i % 2 === 1, text }));
    return [parts.filter((part) => part.text !== "")];
  }
  return splitOutside(statement, /\\q?quad(?![a-zA-Z])/y)
    .map((text) => text.trim())
    .filter((text) => text !== "")
    .map((text) => [{ math: true, text }]);
}

function formula(text: string, wide: boolean): HTMLElement {
  const element = h("span", {});
  katex.render((wide ? "\\displaystyle " : "") + text, element, { output: "htmlAndMathml", throwOnError: false, strict: "ignore" });
  return element;
}

/** The statement as an element; its formulas are readable as MathML too. */
export function typeset(statement: string): HTMLElement {
  const lines = parse(statement);
  const wide = lines.every((line) => line.length === 1);
  return h(
    "div",
    { class: "statement" },
    ...lines.map((line) => h("p", {}, ...line.map((part) => (part.math ? formula(part.text, wide) : part.text)))),
  );
}
