// Which claims are shown.
//   Wish, noWish       what was chosen          matches      whether a claim meets it
//   choices            what there is to choose  sizesText    sizes in words      counts   how many of each status
import type { Claim, Score } from "../report.ts";

export interface Wish {
  paper: string;
  status: string;
  engine: string;
  /** Words, all of which must occur. */
  text: string;
  /** Only claims that need a hypothesis which their paper does not state. */
  unstated: boolean;
}

export const noWish: Wish = { paper: "", status: "", engine: "", text: "", unstated: false };

function searched(claim: Claim): string {
  const hypotheses = claim.hypotheses.map((hypothesis) => hypothesis.words);
  return [claim.id, claim.source, claim.title, claim.statement, claim.remark, ...hypotheses].join("\n").toLowerCase();
}

export function matches(claim: Claim, wish: Wish): boolean {
  if (wish.paper !== "" && claim.paper !== wish.paper) return false;
  if (wish.status !== "" && claim.status !== wish.status) return false;
  if (wish.engine !== "" && !claim.engines.some((finding) => finding.engine === wish.engine)) return false;
  if (wish.unstated && claim.as_printed) return false;
  const text = searched(claim);
  const words = wish.text.toLowerCase().split(/\s+/).filter((word) => word !== "");
  return words.every((word) => text.includes(word));
}

/** Distinct values in the order in which they come. */
export function choices(values: string[]): string[] {
  return [...new Set(values)];
}

/** How often each value comes, in the order in which they come. */
export function counts(values: string[]): Map<string, number> {
  const result = new Map<string, number>();
  for (const value of values) result.set(value, (result.get(value) ?? 0) + 1);
  return result;
}

/** "n ≤ 4, N ≤ 4" for all sizes up to these, otherwise with their number. */
export function sizesText(sizes: [number, number][]): string {
  if (sizes.length === 0) return "–";
  const degrees = sizes.map(([n]) => n);
  const low = Math.min(...degrees);
  const high = Math.max(...degrees);
  const pieces = Math.max(...sizes.map(([, count]) => count));
  const n = low === high ? `n = ${high}` : low === 1 ? `n ≤ ${high}` : `${low} ≤ n ≤ ${high}`;
  const full = sizes.length === (high - low + 1) * pieces;
  return `${n}, N ${pieces === 1 ? "=" : "≤"} ${pieces}${full ? "" : ` (${sizes.length} sizes)`}`;
}

/** "3 of 3", or a dash where there was none. */
export function scoreText(score: Score): string {
  const all = score.killed + score.survived;
  return all === 0 ? "–" : `${score.killed} of ${all}`;
}
