// The geometry of a picture, without any library: positions and colours as lists of numbers.
//   strip            triangles between neighbouring rulings, coloured by warp     lines          some of the rulings
//   netLines         both polygons of the control net and its rulings           edgeRuns       the edge of regression
//   singularLines    rulings with singular points                               sideView       where to look from
import type { Net, Picture, Ruling, State } from "../report.ts";
import { type Rgb, warpColour } from "./colour.ts";

export type Point = [number, number, number];

export function ends(ruling: NonNullable<Ruling>): [Point, Point] {
  return [ruling.slice(0, 3) as Point, ruling.slice(3, 6) as Point];
}

/** Degrees that are rounding errors of doubles. */
export const noWarp = 1e-5;

/** The largest warp angle of all states, in degrees: what the legend ends with. */
export function largestWarp(picture: Picture): number {
  return Math.max(0, ...picture.states.flatMap((state) => state.warp.map((warp) => warp ?? 0)));
}

/** Of a surface that is not warped at all. */
const plain: Rgb = [0.58, 0.66, 0.76];

export interface Strip {
  positions: number[];
  colours: number[];
  triangles: number[];
}

/** Two vertices for each ruling that is drawn, two triangles between neighbours. */
export function strip(state: State, largest: number): Strip {
  const shape: Strip = { positions: [], colours: [], triangles: [] };
  let before = -1;
  state.rulings.forEach((ruling, i) => {
    if (ruling === null) {
      before = -1;
      return;
    }
    const at = shape.positions.length / 3;
    shape.positions.push(...ruling);
    const colour = largest > noWarp ? warpColour((state.warp[i] ?? 0) / largest) : plain;
    shape.colours.push(...colour, ...colour);
    if (before >= 0) shape.triangles.push(before, before + 1, at, before + 1, at + 1, at);
    before = at;
  });
  return shape;
}

/** About `count` rulings as pairs of points, the first and the last among them. */
export function lines(state: State, count: number): number[] {
  const last = state.rulings.length - 1;
  const step = Math.max(1, Math.round(last / count));
  return state.rulings.flatMap((ruling, i) => (ruling !== null && (i % step === 0 || i === last) ? ruling : []));
}

function points(flat: number[]): Point[] {
  const list: Point[] = [];
  for (let i = 0; i + 2 < flat.length; i += 3) list.push(flat.slice(i, i + 3) as Point);
  return list;
}

export interface NetLines {
  c: Point[];
  d: Point[];
  /** Pairs of points c_i, d_i. */
  between: number[];
}

export function netLines(net: Net): NetLines {
  const c = points(net.c.points);
  const d = points(net.d.points);
  return { c, d, between: c.flatMap((point, i) => [...point, ...(d[i] ?? point)]) };
}

/** No further than this from the patch, in lengths of the ruling: the edge may go to infinity. */
const reach = 3;

/** The edge of regression where it is near the patch, in unbroken runs. */
export function edgeRuns(state: State): Point[][] {
  const runs: Point[][] = [];
  let run: Point[] = [];
  state.rulings.forEach((ruling, i) => {
    const v = state.edge?.[i] ?? null;
    if (ruling === null || v === null || Math.abs(v - 0.5) > reach) {
      if (run.length > 0) runs.push(run);
      run = [];
      return;
    }
    const [c, d] = ends(ruling);
    run.push(c.map((x, k) => (1 - v) * x + v * (d[k] as number)) as Point);
  });
  if (run.length > 0) runs.push(run);
  return runs;
}

/** Rulings whose parameters lie in a singular range, or the nearest one to a singular parameter. */
export function singularLines(picture: Picture): number[] {
  const state = picture.states[0];
  if (state === undefined) return [];
  const chosen = new Set<number>();
  for (const { from, to } of picture.singular) {
    const inside = state.t.map((t, i) => (t >= from && t <= to ? i : -1)).filter((i) => i >= 0);
    const nearest = state.t.reduce((best, t, i) => (Math.abs(t - from) < Math.abs((state.t[best] ?? 0) - from) ? i : best), 0);
    for (const i of inside.length > 0 ? inside : [nearest]) chosen.add(i);
  }
  return [...chosen].sort((a, b) => a - b).flatMap((i) => state.rulings[i] ?? []);
}

export interface Box {
  middle: Point;
  /** Half of the diagonal. */
  radius: number;
}

function boxOf(flat: number[]): Box | null {
  const low: Point = [Infinity, Infinity, Infinity];
  const high: Point = [-Infinity, -Infinity, -Infinity];
  flat.forEach((x, i) => {
    const k = (i % 3) as 0 | 1 | 2;
    low[k] = Math.min(low[k], x);
    high[k] = Math.max(high[k], x);
  });
  if (!Number.isFinite(low[0])) return null;
  const middle = low.map((x, k) => (x + (high[k] as number)) / 2) as Point;
  return { middle, radius: Math.max(Math.hypot(...low.map((x, k) => (high[k] as number) - x)) / 2, 1e-6) };
}

/** A net is in sight at first unless the surface would be too small beside it. */
const mostNet = 1.7;

/** The box around all rulings of all states, and around the net if that is not much larger. */
export function box(picture: Picture): Box {
  const rulings = picture.states.flatMap((state) => state.rulings.flatMap((ruling) => ruling ?? []));
  const surface = boxOf(rulings) ?? { middle: [0, 0, 0], radius: 1 };
  if (picture.net === null) return surface;
  const all = boxOf([...rulings, ...picture.net.c.points, ...picture.net.d.points]);
  return all !== null && all.radius <= mostNet * surface.radius ? all : surface;
}

/** Eigenvectors of a symmetric matrix by Jacobi's rotations, that of the least eigenvalue first. */
export function axes(matrix: number[][]): Point[] {
  const a = matrix.map((row) => [...row]);
  const vectors: Point[] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const at = (i: number, j: number) => (a[i] as number[])[j] as number;
  for (let sweep = 0; sweep < 20; ++sweep) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]] as const) {
      const angle = Math.atan2(2 * at(p, q), at(p, p) - at(q, q)) / 2;
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      const turn = (x: number[], y: number[]) => {
        for (let k = 0; k < 3; ++k) [x[k], y[k]] = [cos * (x[k] as number) + sin * (y[k] as number), cos * (y[k] as number) - sin * (x[k] as number)];
      };
      turn(a[p] as number[], a[q] as number[]);
      for (const row of a) [row[p], row[q]] = [cos * (row[p] as number) + sin * (row[q] as number), cos * (row[q] as number) - sin * (row[p] as number)];
      turn(vectors[p] as Point, vectors[q] as Point);
    }
  }
  return [0, 1, 2].sort((i, j) => at(i, i) - at(j, j)).map((i) => vectors[i] as Point);
}

/** Where to look from, so that the surface is seen about as broad as it is: along its least axis, from above, tilted towards its middle one. */
export function sideView(picture: Picture): Point {
  const all = picture.states.flatMap((state) => state.rulings.flatMap((ruling) => (ruling === null ? [] : ends(ruling))));
  const mean = [0, 1, 2].map((k) => all.reduce((sum, point) => sum + (point[k] as number), 0) / Math.max(all.length, 1));
  const spread = [0, 1, 2].map((i) => [0, 1, 2].map((j) => all.reduce((sum, x) => sum + ((x[i] as number) - (mean[i] as number)) * ((x[j] as number) - (mean[j] as number)), 0)));
  const [least, middle] = axes(spread) as [Point, Point, Point];
  const up = least[2] < 0 ? -1 : 1;
  const side = middle[2] < 0 ? -1 : 1;
  return least.map((x, k) => up * x + 0.35 * side * (middle[k] as number)) as Point;
}
