// Figures of the papers, rebuilt: the drawing, and each of its surfaces in 3D.
import { h } from "./dom.ts";
import type { FiguresSection, Picture } from "./report.ts";
import { surfaceView } from "./scene/surface.ts";

/** An image cannot run a script, whatever is in it. */
function drawing(svg: string, text: string): HTMLElement {
  return h("img", { class: "drawing", src: `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`, alt: text, loading: "lazy" });
}

function figure(entry: FiguresSection["figures"][number], pictures: (Picture | null)[]): HTMLElement {
  const surfaces = pictures.filter((picture) => picture !== null);
  return h(
    "article",
    { class: "surface", id: entry.id, "aria-labelledby": `${entry.id}-title` },
    h("h3", { id: `${entry.id}-title` }, h("a", { href: `#${entry.id}`, class: "id" }, entry.id), ` ${entry.title}`),
    h("p", { class: "source" }, entry.caption),
    entry.svg === null ? null : drawing(entry.svg, `${entry.title}. ${entry.caption}`),
    surfaces.length === 0
      ? null
      : h("div", { class: "gallery" }, ...surfaces.map((picture) => h("div", { class: "part" }, h("h4", {}, picture.name), surfaceView(picture)))),
  );
}

export function figuresView(section: FiguresSection): HTMLElement {
  return h(
    "section",
    { id: "figures", "aria-labelledby": "figures-title" },
    h("h2", { id: "figures-title" }, "Figures of the papers"),
    h("p", { class: "lead" }, "Rebuilt from surfaces that the library computes. Turn them: drag, or use the arrow keys."),
    ...section.figures.map((entry, i) => figure(entry, section.pictures[i] ?? [])),
  );
}
