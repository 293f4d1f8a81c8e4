// What torse fit made of a pair of rails: numbers, the strip before and after, curves, and why it is no better.
import { h, table } from "./dom.ts";
import { plotView } from "./plots.ts";
import type { FitSection, FittedSurface, Picture, PlotData, State } from "./report.ts";
import { surfaceView } from "./scene/surface.ts";

const obstacles: Record<string, string> = {
  tangents: "no ruling from there to any point of the second rail is developable",
  "beyond-begin": "the developable rulings lead beyond the begin of the second rail",
  "beyond-end": "the developable rulings lead beyond the end of the second rail",
  order: "the developable rulings would cross good ones beside them",
  mapping: "developable rulings in order exist, but the mapping does not reach them: more coefficients or free ends may help",
};

function degrees(value: number): string {
  return value.toPrecision(6);
}

/** Found by sampling: six digits say more than enough. */
function parameter(value: string | number): string {
  return String(Number(Number(value).toPrecision(6)));
}

function curve(state: State, value: (i: number) => number | null | undefined): [number, number][] {
  return state.t.flatMap((t, i) => {
    const y = value(i);
    return y === null || y === undefined ? [] : [[t, y] as [number, number]];
  });
}

function plots(surface: FittedSurface, picture: Picture | null): PlotData[] {
  const states = picture?.states ?? [];
  const list: PlotData[] = [
    {
      title: "Warp angle along the first rail",
      x: { label: "t" },
      y: { label: "degrees", log: true },
      series: states.map((state) => ({ name: state.label, points: curve(state, (i) => state.warp[i]) })),
    },
    {
      title: "Mapping from the first rail to the second",
      x: { label: "t" },
      y: { label: "T" },
      series: states.map((state) => ({ name: state.label, points: curve(state, (i) => state.targets[i]) })),
    },
  ];
  const convergence = surface.fit?.curve ?? [];
  if (convergence.length > 1) {
    list.push({
      title: "Convergence: the least value so far",
      x: { label: "milliseconds" },
      y: { label: surface.method === "warp" ? "degrees" : "objective", log: true },
      series: [{ name: "least so far", points: convergence.map(([seconds, value]) => [1000 * seconds, value]) }],
    });
  }
  return list;
}

function certificates(surface: FittedSurface): HTMLElement {
  const { lo, hi } = surface.max_warp_deg;
  const turns = surface.folds.folded;
  const crosses = surface.self_intersection.crosses;
  return h(
    "ul",
    { class: "findings" },
    h("li", {}, surface.developable ? "Exactly developable." : `Certified: the largest warp angle is between ${lo} and ${hi} degrees.`),
    h("li", {}, turns ? `The normal turns by more than 90 degrees along the ruling at ${surface.folds.at ?? "some parameter"}.` : "Certified: the normal turns by at most 90 degrees along every ruling, so there is no edge of regression between the rails."),
    h("li", {}, crosses === false ? "Certified: no two rulings cross." : crosses ? "Two rulings cross." : "Whether rulings cross is not decided."),
    h("li", {}, `The surface has degree ${surface.surface.degree}, ${surface.surface.pieces} pieces and ${surface.surface.points} points on each rail, and is exactly bounded by both rails.`),
  );
}

function explanations(surface: FittedSurface): HTMLElement | null {
  if (surface.findings.length === 0) return null;
  const rows = surface.findings.map(({ from, to, obstacle, mean_deg, max_deg, best_deg }) => [
    `${parameter(from)} to ${parameter(to)}`,
    obstacles[obstacle] ?? obstacle,
    mean_deg.toPrecision(3),
    max_deg.toPrecision(3),
    best_deg.toPrecision(3),
  ]);
  return table(`Where the warp exceeds ${surface.threshold_deg} degrees, and why`, ["Parameters", "Why", "Mean", "Largest", "Best possible mean"], rows, [2, 3, 4]);
}

function strip(surface: FittedSurface, picture: Picture | null): HTMLElement {
  const statistic = (name: string, key: keyof FittedSurface["before"]) => [name, degrees(surface.before[key]), degrees(surface.after[key])];
  return h(
    "article",
    { class: "surface fit" },
    h("h3", {}, surface.file),
    h("p", { class: "source" }, `method ${surface.method}, measure ${surface.measure}, ends ${surface.ends}`),
    table("Warp angles of sampled rulings, degrees", ["Angle", "T = t", "fitted"], [statistic("mean", "mean_deg"), statistic("root mean square", "rms_deg"), statistic("largest", "max_deg")], [1, 2]),
    picture === null ? null : surfaceView(picture),
    certificates(surface),
    h("div", { class: "plots" }, ...plots(surface, picture).map(plotView)),
    explanations(surface),
  );
}

export function fitView(section: FitSection): HTMLElement {
  return h(
    "section",
    { id: "fit", "aria-labelledby": "fit-title" },
    h("h2", { id: "fit-title" }, "Before and after"),
    ...section.data.surfaces.map((surface, i) => strip(surface, section.pictures[i] ?? null)),
  );
}
