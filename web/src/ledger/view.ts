// The ledger: filters, and a card for each claim.
import { command, h, table } from "../dom.ts";
import type { Claim, LedgerSection } from "../report.ts";
import { typeset } from "../statement.ts";
import { choices, counts, matches, noWish, scoreText, sizesText, type Wish } from "./filter.ts";
import { whenIdle } from "../idle.ts";

const papers: Record<string, string> = {
  FJ07: "FJ07: developable spline surfaces of degree n",
  ZW06: "ZW06: developable Bézier surfaces through a directrix",
  FJ21: "FJ21: rational developable spline surfaces",
  BZZ19: "BZZ19: quasi-developable surfaces between two curves",
};

export function badge(status: string): HTMLElement {
  return h("span", { class: `badge ${status.toLowerCase()}` }, status);
}

function seconds(value: number): string {
  return `${value < 10 ? value.toPrecision(2) : value.toFixed(0)} s`;
}

function fact(name: string, value: string | null): HTMLElement | null {
  return value === null ? null : h("div", {}, h("dt", {}, name), h("dd", {}, value));
}

function hypothesesOf(claim: Claim): HTMLElement | null {
  if (claim.hypotheses.length === 0) return null;
  const items = claim.hypotheses.map(({ words, stated }) =>
    h("li", {}, words, stated ? null : h("strong", { class: "unstated" }, " (not stated in the paper)")),
  );
  return h("div", {}, h("h5", {}, "Hypotheses"), h("ul", {}, ...items));
}

function enginesOf(claim: Claim, effort: string): HTMLElement {
  const rows = claim.engines.map((finding) => [
    finding.engine,
    finding.status,
    sizesText(finding.sizes),
    finding.error_log2 === null ? "–" : h("span", {}, "2", h("sup", {}, String(Math.round(finding.error_log2)))),
    [finding.detail, ...finding.survivors.map((survivor) => h("div", { class: "bad" }, `survived: ${survivor}`))],
    seconds(finding.seconds),
    command(`torse verify --claim ${claim.id} --engine ${finding.engine} --effort ${effort} --seed ${claim.seed}`),
  ]);
  return table(`Engines that ran ${claim.id}`, ["Engine", "Finding", "Sizes", "Error", "Detail", "Time", "Run it again"], rows, [5]);
}

function detailsOf(claim: Claim, effort: string): HTMLElement {
  const details = h("details", {}, h("summary", {}, "Hypotheses, engines, replay"));
  details.addEventListener(
    "toggle",
    () => {
      const remark = claim.remark === "" ? null : h("p", { class: "remark" }, claim.remark);
      const coq = claim.coq === null ? null : h("p", {}, "Proved in Coq for every size: ", h("code", {}, claim.coq));
      details.append(...[remark, hypothesesOf(claim), coq, enginesOf(claim, effort)].filter((part) => part !== null));
    },
    { once: true },
  );
  return details;
}

function card(claim: Claim, effort: string): HTMLElement {
  const statement = h("div", { class: "statement" });
  whenIdle(() => statement.replaceWith(typeset(claim.statement)));
  return h(
    "article",
    { class: "claim", id: claim.id, "aria-labelledby": `${claim.id}-title` },
    h(
      "header",
      {},
      h("h4", { id: `${claim.id}-title` }, h("a", { href: `#${claim.id}`, class: "id" }, claim.id), ` ${claim.title}`),
      badge(claim.status),
    ),
    h("p", { class: "source" }, claim.source, claim.as_printed ? null : h("span", { class: "unstated" }, " · needs a hypothesis that the paper does not state")),
    statement,
    h(
      "dl",
      { class: "facts" },
      fact("by", claim.engine),
      fact("sizes", sizesText(claim.sizes)),
      claim.error_log2 === null ? null : h("div", {}, h("dt", {}, "error"), h("dd", {}, "2", h("sup", {}, String(Math.round(claim.error_log2))))),
      fact("mutants killed", scoreText(claim.mutants)),
      fact("faults noticed", scoreText(claim.faults)),
      fact("time", seconds(claim.seconds)),
    ),
    detailsOf(claim, effort),
  );
}

function select(name: string, all: string, values: string[], choose: (value: string) => void): HTMLElement {
  const list = h("select", { id: `choose-${name}`, name }, h("option", { value: "" }, all), ...values.map((value) => h("option", { value }, value)));
  list.addEventListener("change", () => choose(list.value));
  return h("div", { class: "choice" }, h("label", { for: `choose-${name}` }, name), list);
}

function filters(claims: Claim[], changed: (wish: Wish) => void): HTMLElement {
  const wish = { ...noWish };
  const set = <K extends keyof Wish>(key: K, value: Wish[K]) => {
    wish[key] = value;
    changed(wish);
  };
  const search = h("input", { type: "search", id: "search", name: "search", placeholder: "edge of regression" });
  search.addEventListener("input", () => set("text", search.value));
  const unstated = h("input", { type: "checkbox", name: "unstated" });
  unstated.addEventListener("change", () => set("unstated", unstated.checked));
  return h(
    "form",
    { class: "filters", role: "search", "aria-label": "Claims", submit: (event) => event.preventDefault() },
    h("div", { class: "choice grow" }, h("label", { for: "search" }, "Search"), search),
    select("Paper", "All papers", choices(claims.map((claim) => claim.paper)), (value) => set("paper", value)),
    select("Status", "Any status", choices(claims.map((claim) => claim.status)), (value) => set("status", value)),
    select("Engine", "Any engine", choices(claims.flatMap((claim) => claim.engines.map((finding) => finding.engine))), (value) => set("engine", value)),
    h("label", { class: "check" }, unstated, h("span", {}, "Only with a hypothesis not stated in the paper")),
  );
}

function summary(claims: Claim[]): HTMLElement {
  const statuses = [...counts(claims.map((claim) => claim.status)).keys()];
  const rows = choices(claims.map((claim) => claim.paper)).map((paper) => {
    const own = claims.filter((claim) => claim.paper === paper);
    const by = counts(own.map((claim) => claim.status));
    const sum = (score: (claim: Claim) => number) => String(own.reduce((total, claim) => total + score(claim), 0));
    return [
      paper,
      ...statuses.map((status) => String(by.get(status) ?? 0)),
      String(own.filter((claim) => !claim.as_printed).length),
      `${sum((c) => c.mutants.killed)} of ${sum((c) => c.mutants.killed + c.mutants.survived)}`,
      `${sum((c) => c.faults.killed)} of ${sum((c) => c.faults.killed + c.faults.survived)}`,
    ];
  });
  const head = ["Paper", ...statuses, "Need an unstated hypothesis", "Mutants killed", "Faults noticed"];
  return table("Claims by paper", head, rows, head.map((_, i) => i).slice(1));
}

export function ledgerView(section: LedgerSection): HTMLElement {
  const { claims, effort, seed } = section.data;
  const cards = claims.map((claim) => ({ claim, element: card(claim, effort) }));
  const groups = choices(claims.map((claim) => claim.paper)).map((paper) => {
    const own = cards.filter(({ claim }) => claim.paper === paper);
    return { own, element: h("section", { "aria-label": paper }, h("h3", {}, papers[paper] ?? paper), ...own.map(({ element }) => element)) };
  });
  const count = h("p", { class: "count", role: "status", "aria-live": "polite" });
  const show = (wish: Wish) => {
    let shown = 0;
    for (const { claim, element } of cards) {
      element.hidden = !matches(claim, wish);
      if (!element.hidden) ++shown;
    }
    for (const { own, element } of groups) element.hidden = own.every((entry) => entry.element.hidden);
    count.textContent = shown === claims.length ? `${claims.length} claims` : `${shown} of ${claims.length} claims`;
  };
  show(noWish);
  return h(
    "section",
    { class: "ledger", id: "ledger", "aria-labelledby": "ledger-title" },
    h("h2", { id: "ledger-title" }, "What was proved"),
    h(
      "p",
      { class: "lead" },
      `Every numbered statement of the papers, run by the library's own functions in every arithmetic (${effort} effort, seed ${seed}). `,
      h("strong", {}, "Proved"),
      " means that the difference of both sides is the zero function with all knots, parameters and control points indeterminates, for the sizes given. ",
      "A mutant is a wrong variant of the statement, a fault a corrupted operation; both must be noticed.",
    ),
    summary(claims),
    filters(claims, show),
    count,
    ...groups.map(({ element }) => element),
  );
}
