// Worked examples: what the paper prints beside what the library computes.
import { h, table } from "./dom.ts";
import { choices } from "./ledger/filter.ts";
import type { ExamplesSection } from "./report.ts";
import { surfaceView } from "./scene/surface.ts";

export function examplesView(section: ExamplesSection): HTMLElement {
  const parts = section.data.examples.map((example, i) => {
    const picture = section.pictures[i] ?? null;
    const equal = example.values.filter((value) => value.equal).length;
    const tables = choices(example.values.map((value) => value.group)).map((group) =>
      table(
        group,
        ["Value", "Printed", "Computed", "Equal"],
        example.values
          .filter((value) => value.group === group)
          .map((value) => [
            value.label,
            h("code", {}, value.printed),
            h("code", {}, value.computed),
            value.equal ? h("span", { class: "good" }, "equal") : h("strong", { class: "bad" }, "differs"),
          ]),
      ),
    );
    return h(
      "article",
      { class: "example" },
      h("h3", {}, example.source),
      h("p", { class: "lead" }, `${equal} of ${example.values.length} printed values reproduced exactly.`),
      picture === null ? null : surfaceView(picture),
      h("div", { class: "columns" }, ...tables),
    );
  });
  return h(
    "section",
    { id: "examples", "aria-labelledby": "examples-title" },
    h("h2", { id: "examples-title" }, "Worked example"),
    ...parts,
  );
}
