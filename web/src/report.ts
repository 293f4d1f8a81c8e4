// The data of a report as the program writes them: docs/report.md.

export interface Report {
  torse: 1;
  type: "report";
  version: string;
  title: string;
  command: string;
  sections: Section[];
  /** What was left out to keep the page small. */
  notes: string[];
}

export type Section = LedgerSection | ExamplesSection | SurfacesSection | FitSection | FiguresSection | PlotsSection;

export interface Score {
  killed: number;
  survived: number;
  equivalent: number;
}

export interface Finding {
  engine: string;
  status: string;
  sizes: [number, number][];
  trials: number;
  discards: number;
  error_log2: number | null;
  detail: string;
  survivors: string[];
  seconds: number;
}

export interface Claim {
  id: string;
  paper: string;
  source: string;
  title: string;
  statement: string;
  status: string;
  engine: string | null;
  sizes: [number, number][];
  error_log2: number | null;
  hypotheses: { words: string; stated: boolean }[];
  as_printed: boolean;
  remark: string;
  coq: string | null;
  mutants: Score;
  faults: Score;
  seed: number;
  seconds: number;
  engines: Finding[];
}

export interface LedgerSection {
  kind: "ledger";
  data: { effort: string; seed: number; claims: Claim[] };
}

export interface ExampleValue {
  group: string;
  label: string;
  printed: string;
  computed: string;
  equal: boolean;
}

export interface ExamplesSection {
  kind: "examples";
  data: { examples: { id: string; source: string; values: ExampleValue[] }[] };
  pictures: (Picture | null)[];
}

/** Six coordinates, of the ends on c and on d; null where they are not finite. */
export type Ruling = number[] | null;

export interface State {
  label: string;
  /** Parameters on c and on d, over [0, 1]. */
  t: number[];
  targets: number[];
  rulings: Ruling[];
  /** Degrees. */
  warp: (number | null)[];
  /** v of the point (1-v) c + v d of the edge of regression. */
  edge?: (number | null)[];
}

export interface Row {
  points: number[];
  weights: number[];
}

export interface Net {
  degree: number;
  knots: number[];
  c: Row;
  d: Row;
}

/** A ruled surface of size 1 around the origin. */
export interface Picture {
  name: string;
  /** The true size, in the unit of the file. */
  size: string;
  net: Net | null;
  states: State[];
  singular: { reason: string; from: number; to: number }[];
}

export interface Enclosure {
  lo: number;
  hi: number;
}

export interface CheckedSurface {
  file: string;
  name: string;
  developable: boolean | null;
  class: string;
  max_warp_deg?: Enclosure;
}

export interface Verdict {
  title: string;
  verdict: string;
  outcome: string;
  findings: string[];
  replay: string;
}

export interface SurfacesSection {
  kind: "surfaces";
  data: { surfaces: CheckedSurface[]; errors: { file: string; message: string }[] };
  verdicts: Verdict[];
  pictures: (Picture | null)[];
}

export interface Statistics {
  mean_deg: number;
  rms_deg: number;
  max_deg: number;
}

export interface FittedSurface {
  file: string;
  name: string;
  method: string;
  measure: string;
  ends: string;
  developable: boolean;
  before: Statistics;
  after: Statistics;
  max_warp_deg: Enclosure;
  surface: { degree: number; pieces: number; points: number };
  folds: { folded: boolean; at?: string };
  self_intersection: { crosses: boolean | null };
  threshold_deg: number;
  findings: { from: string | number; to: string | number; obstacle: string; mean_deg: number; max_deg: number; best_deg: number }[];
  fit?: { curve: [number, number][] };
}

export interface FitSection {
  kind: "fit";
  data: { surfaces: FittedSurface[] };
  pictures: (Picture | null)[];
}

export interface FiguresSection {
  kind: "figures";
  figures: { id: string; title: string; caption: string; svg: string | null }[];
  /** The surfaces of each figure. */
  pictures: (Picture | null)[][];
}

export interface Axis {
  label: string;
  log?: boolean;
}

export interface Series {
  name: string;
  points: [number, number][];
  /** Dots in the place of a line. */
  dots?: boolean;
}

export interface PlotData {
  title: string;
  x: Axis;
  y: Axis;
  series: Series[];
}

/** Paragraphs, plots and tables of any kind. */
export interface PlotsSection {
  kind: "plots";
  title: string;
  text: string[];
  plots: PlotData[];
  tables: { title: string; columns: string[]; rows: (string | number | null)[][] }[];
}

/** Reads the data that the program put into the page. */
export function readReport(): Report {
  const text = document.getElementById("report")?.textContent ?? "";
  const report = JSON.parse(text) as Report;
  if (report.torse !== 1 || report.type !== "report") throw new Error("this is not a report of torse");
  return report;
}
