// What torse check found: a list of the surfaces, then each with its picture.
import { command, h, table } from "./dom.ts";
import { counts } from "./ledger/filter.ts";
import type { CheckedSurface, Picture, SurfacesSection, Verdict } from "./report.ts";
import { surfaceView } from "./scene/surface.ts";

const kinds: Record<string, string> = { passed: "good", failed: "bad", undecided: "doubt" };

/** The bounds as they are in the JSON. */
export function warpText(surface: CheckedSurface): string {
  const warp = surface.max_warp_deg;
  if (warp === undefined) return "–";
  return warp.hi === 0 ? "0" : `${warp.lo} to ${warp.hi}`;
}

function list(section: SurfacesSection): HTMLElement {
  const rows = section.data.surfaces.map((surface, i) => {
    const verdict = section.verdicts[i] as Verdict;
    return [
      h("a", { href: `#surface-${i}` }, verdict.title),
      h("span", { class: `badge ${kinds[verdict.outcome] ?? ""}` }, verdict.outcome),
      verdict.verdict,
      surface.class,
      warpText(surface),
    ];
  });
  return table("All surfaces", ["Surface", "Result", "Verdict", "Class", "Largest warp angle, degrees"], rows);
}

function card(verdict: Verdict, picture: Picture | null, i: number): HTMLElement {
  return h(
    "article",
    { class: "surface", id: `surface-${i}`, "aria-labelledby": `surface-${i}-title` },
    h("header", {}, h("h3", { id: `surface-${i}-title` }, verdict.title), h("span", { class: `badge ${kinds[verdict.outcome] ?? ""}` }, verdict.verdict)),
    h("ul", { class: "findings" }, ...verdict.findings.map((finding) => h("li", {}, finding))),
    picture === null ? h("p", { class: "note" }, "There is no picture of this surface.") : surfaceView(picture),
    command(verdict.replay),
  );
}

export function surfacesView(section: SurfacesSection): HTMLElement {
  const { surfaces, errors } = section.data;
  const tally = [...counts(section.verdicts.map(({ verdict }) => verdict))].map(([verdict, count]) => `${count} ${verdict}`);
  const lead = `${surfaces.length} surfaces: ${tally.join(", ")}${errors.length === 0 ? "" : `; ${errors.length} unreadable files`}.`;
  return h(
    "section",
    { id: "surfaces", "aria-labelledby": "surfaces-title" },
    h("h2", { id: "surfaces-title" }, "Surfaces"),
    h("p", { class: "lead" }, lead, " Verdicts are exact; bounds of warp angles are certified. Pictures are sampled."),
    surfaces.length === 0 ? null : list(section),
    errors.length === 0 ? null : table("Files that could not be read", ["File", "Error"], errors.map(({ file, message }) => [file, message])),
    h("div", { class: "gallery" }, ...section.verdicts.map((verdict, i) => card(verdict, section.pictures[i] ?? null, i))),
  );
}
