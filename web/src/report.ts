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

export type Section = LedgerSection | ExamplesSection;

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
}

/** Reads the data that the program put into the page. */
export function readReport(): Report {
  const text = document.getElementById("report")?.textContent ?? "";
  const report = JSON.parse(text) as Report;
  if (report.torse !== 1 || report.type !== "report") throw new Error("this is not a report of torse");
  return report;
}
