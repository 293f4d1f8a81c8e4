// The page of a report.
import { command, h } from "./dom.ts";
import { examplesView } from "./examples.ts";
import { figuresView } from "./figures.ts";
import { fitView } from "./fit.ts";
import { whenIdle } from "./idle.ts";
import { ledgerView } from "./ledger/view.ts";
import { plotsView } from "./plots.ts";
import { readReport, type Report, type Section } from "./report.ts";
import { surfacesView } from "./surfaces.ts";
import { themeButton } from "./theme.ts";

function view(section: Section, index: number): HTMLElement {
  switch (section.kind) {
    case "ledger":
      return ledgerView(section);
    case "examples":
      return examplesView(section);
    case "surfaces":
      return surfacesView(section);
    case "fit":
      return fitView(section);
    case "figures":
      return figuresView(section);
    case "plots":
      return plotsView(section, index);
  }
}

function head(report: Report, sections: HTMLElement[]): HTMLElement {
  const links = sections.map((section) =>
    h("li", {}, h("a", { href: `#${section.id}` }, section.querySelector("h2")?.textContent ?? section.id)),
  );
  return h(
    "header",
    { class: "page" },
    h("div", { class: "bar" }, h("p", { class: "brand" }, "torse"), themeButton()),
    h("h1", {}, report.title),
    sections.length > 1 ? h("nav", { "aria-label": "Sections" }, h("ul", {}, ...links)) : null,
  );
}

function foot(report: Report): HTMLElement {
  return h(
    "footer",
    { class: "page" },
    h("h2", {}, "Make this report again"),
    h("p", {}, command(report.command)),
    ...report.notes.map((note) => h("p", { class: "note" }, note)),
    h("p", { class: "note" }, `torse ${report.version}. This page needs no network; its numbers are those of the option --json.`),
  );
}

function show(report: Report): void {
  document.title = `${report.title} – torse`;
  const sections = report.sections.map(view);
  document.body.append(
    head(report, sections),
    h("main", { id: "content", tabindex: -1 }, ...sections),
    foot(report),
  );
  whenIdle(() => undefined);
  if (location.hash.length > 1) document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView();
}

try {
  show(readReport());
} catch (error) {
  document.body.append(h("main", { id: "content" }, h("h1", {}, "This report cannot be shown"), h("p", {}, String(error))));
  throw error;
}
