// Plots as SVG, each with its numbers as a table for those who do not see it.
//   plotView        one plot          plotsView     a section of text, plots and tables
import * as Plot from "@observablehq/plot";
import { h, table } from "./dom.ts";
import type { PlotData, PlotsSection, Series } from "./report.ts";

/** What a logarithmic axis can show. */
export function shown(data: PlotData): Series[] {
  const fits = (x: number, log: boolean | undefined) => Number.isFinite(x) && (log !== true || x > 0);
  return data.series.map((series) => ({
    ...series,
    points: series.points.filter(([x, y]) => fits(x, data.x.log) && fits(y, data.y.log)),
  }));
}

function number(value: number): string {
  return Number.isInteger(value) && Math.abs(value) < 1e6 ? String(value) : value.toPrecision(4);
}

/** "fitted: 240 points, y from 0.01 to 21" for each series. */
export function description(data: PlotData): string {
  const parts = shown(data).map(({ name, points }) => {
    if (points.length === 0) return `${name}: no points`;
    const y = points.map((point) => point[1]);
    return `${name}: ${points.length} points, from ${number(Math.min(...y))} to ${number(Math.max(...y))}`;
  });
  return `${data.title}: ${data.y.label} by ${data.x.label}. ${parts.join("; ")}.`;
}

/** Evenly chosen entries, the first and the last among them. */
export function thinned<T>(list: T[], most: number): T[] {
  if (list.length <= most) return list;
  return Array.from({ length: most }, (_, i) => list[Math.round((i * (list.length - 1)) / (most - 1))] as T);
}

const colours = ["var(--series-1)", "var(--series-2)", "var(--series-3)", "var(--series-4)", "var(--series-5)", "var(--series-6)"];

/** Lines through so few points show them. */
const fewPoints = 30;

/** Lines of one colour differ in their dashes. */
const dashes = ["none", "7 4", "2 3"];

interface Look {
  colour: string;
  dash: string;
}

export function lookOf(index: number): Look {
  return { colour: colours[index % colours.length] as string, dash: dashes[Math.floor(index / colours.length) % dashes.length] as string };
}

function drawing(data: PlotData): SVGElement | HTMLElement {
  const series = shown(data);
  const marks = series.flatMap(({ name, points, dots }, i) => {
    const { colour, dash } = lookOf(i);
    const rows = points.map(([x, y]) => ({ x, y, name }));
    const dot = Plot.dot(rows, { x: "x", y: "y", stroke: colour, r: 2.5 });
    if (dots === true) return [dot];
    const line = Plot.line(rows, { x: "x", y: "y", stroke: colour, strokeDasharray: dash, strokeWidth: 1.8 });
    return points.length <= fewPoints ? [line, dot] : [line];
  });
  const all = series.flatMap(({ name, points }) => points.map(([x, y]) => ({ x, y, name })));
  const axis = (log: boolean | undefined) => (log === true ? ({ type: "log", tickFormat: "~g", ticks: 5 } as const) : ({ type: "linear", ticks: 6 } as const));
  const picture = Plot.plot({
    width: 520,
    height: 300,
    marginLeft: 58,
    marginBottom: 42,
    grid: true,
    style: { fontSize: "12px", overflow: "visible" },
    x: { label: data.x.label, ...axis(data.x.log) },
    y: { label: data.y.label, ...axis(data.y.log) },
    marks: [
      Plot.frame({ stroke: "var(--line)" }),
      ...marks,
      Plot.tip(all, Plot.pointer({ x: "x", y: "y", title: (row: (typeof all)[number]) => `${row.name}\n${number(row.x)}: ${number(row.y)}`, fill: "var(--card)", stroke: "var(--soft)" })),
    ],
  });
  // The picture is one image to a screen reader; labels within it have no role that may have one.
  for (const part of picture.querySelectorAll("[aria-label]")) part.removeAttribute("aria-label");
  picture.setAttribute("role", "img");
  picture.setAttribute("aria-label", description(data));
  return picture;
}

/** The names in the order of the lines. */
function key(data: PlotData): HTMLElement | null {
  if (data.series.length < 2) return null;
  const items = data.series.map(({ name }, i) => {
    const { colour, dash } = lookOf(i);
    const style = dash === "none" ? "solid" : dash.startsWith("7") ? "dashed" : "dotted";
    return h("li", {}, h("span", { class: "swatch", style: `border-top: 3px ${style} ${colour}` }), name);
  });
  return h("ul", { class: "key" }, ...items);
}

const mostRows = 200;

function numbers(data: PlotData): HTMLElement {
  const details = h("details", {}, h("summary", {}, "The numbers"));
  details.addEventListener(
    "toggle",
    () => {
      for (const { name, points } of data.series) {
        const rows = thinned(points, mostRows).map(([x, y]) => [number(x), number(y)]);
        const caption = points.length > mostRows ? `${name}: ${mostRows} of ${points.length} points` : name;
        details.append(table(caption, [data.x.label, data.y.label], rows, [0, 1]));
      }
    },
    { once: true },
  );
  return details;
}

export function plotView(data: PlotData): HTMLElement {
  return h("figure", { class: "plot" }, h("figcaption", {}, data.title), drawing(data), key(data), numbers(data));
}

export function plotsView(section: PlotsSection, index: number): HTMLElement {
  const id = `plots-${index}`;
  const text = (value: string | number | null) => (value === null ? "–" : typeof value === "number" ? number(value) : value);
  const tables = section.tables.map(({ title, columns, rows }) => {
    const numeric = columns.map((_, i) => i).filter((i) => rows.every((row) => typeof row[i] !== "string"));
    return table(title, columns, rows.map((row) => row.map(text)), numeric);
  });
  return h(
    "section",
    { id, "aria-labelledby": `${id}-title` },
    h("h2", { id: `${id}-title` }, section.title),
    ...section.text.map((paragraph) => h("p", { class: "lead" }, paragraph)),
    h("div", { class: "plots" }, ...section.plots.map(plotView)),
    ...tables,
  );
}
