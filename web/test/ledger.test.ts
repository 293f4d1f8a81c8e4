// The page of torse verify: every number is that of --json, filters, keyboard, print, accessibility.
import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import type { Claim } from "../src/report.ts";
import { audit, launch, openPage, readJson, scratch, torse } from "./browser.ts";

const folder = scratch();
const json = join(folder.path, "ledger.json");
const html = join(folder.path, "pages/ledger");
const file = join(html, "index.html");
let browser: Browser;
let claims: Claim[];

before(async () => {
  torse(["verify", "--effort", "quick", "--json", json, "--html", html]);
  claims = readJson<{ claims: Claim[] }>(json).claims;
  browser = await launch();
});

after(async () => {
  await browser?.close();
  folder.remove();
});

const visible = (page: Page) => page.$$eval(".claim:not([hidden])", (list) => list.map((element) => element.id));

test("opens from a file without errors or requests, below 5 MiB", async () => {
  const { page, complaints } = await openPage(browser, file);
  assert.deepEqual(complaints, []);
  assert.equal(await page.title(), "The papers' claims – torse");
  assert.ok(statSync(file).size < 5 * 1024 * 1024);
  await page.context().close();
});

test("shows each claim with the numbers of --json", async () => {
  const { page } = await openPage(browser, file);
  const shown = await page.$$eval(".claim", (cards) =>
    cards.map((card) => ({
      id: card.id,
      title: card.querySelector("h4")?.textContent,
      status: card.querySelector(".badge")?.textContent,
      facts: Object.fromEntries([...card.querySelectorAll(".facts div")].map((row) => [row.firstChild?.textContent, row.lastChild?.textContent])),
    })),
  );
  assert.equal(shown.length, claims.length);
  assert.ok(claims.length > 80);
  const of = (score: { killed: number; survived: number }) => `${score.killed} of ${score.killed + score.survived}`;
  claims.forEach((claim, i) => {
    const card = shown[i];
    assert.equal(card?.id, claim.id);
    assert.equal(card.title, `${claim.id} ${claim.title}`);
    assert.equal(card.status, claim.status);
    assert.equal(card.facts["by"], claim.engine);
    assert.equal(card.facts["mutants killed"], of(claim.mutants));
    assert.equal(card.facts["error"], claim.error_log2 === null ? undefined : `2${Math.round(claim.error_log2)}`);
    assert.equal(Number.parseFloat(card.facts["time"] ?? ""), Number(claim.seconds < 10 ? claim.seconds.toPrecision(2) : claim.seconds.toFixed(0)));
  });
  const sums = await page.$$eval(".ledger table tbody tr", (rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
  for (const [paper, proved] of sums) {
    assert.equal(Number(proved), claims.filter((claim) => claim.paper === paper && claim.status === "Proved").length);
  }
  await page.context().close();
});

test("typesets every statement, for readers as MathML too", async () => {
  const { page } = await openPage(browser, file);
  assert.equal(await page.locator(".katex-error").count(), 0);
  const without = await page.$$eval(".claim", (cards) => cards.filter((card) => card.querySelector(".statement .katex math") === null).map((card) => card.id));
  assert.deepEqual(without, []);
  await page.context().close();
});

test("filters by paper, engine, text and unstated hypotheses, and tells how many are left", async () => {
  const { page } = await openPage(browser, file);
  const count = () => page.locator("[role=status]").textContent();
  assert.equal(await count(), `${claims.length} claims`);
  await page.getByLabel("Paper", { exact: true }).selectOption("ZW06");
  const zw06 = claims.filter((claim) => claim.paper === "ZW06").map((claim) => claim.id);
  assert.deepEqual(await visible(page), zw06);
  assert.equal(await count(), `${zw06.length} of ${claims.length} claims`);
  await page.getByLabel("Engine", { exact: true }).selectOption("modular");
  const modular = (claim: Claim) => claim.engines.some((finding) => finding.engine === "modular");
  assert.deepEqual(await visible(page), claims.filter((claim) => claim.paper === "ZW06" && modular(claim)).map((claim) => claim.id));
  await page.getByLabel("Engine", { exact: true }).selectOption("");
  await page.getByLabel("Paper", { exact: true }).selectOption("");
  await page.getByLabel("Search").fill("worked example");
  assert.deepEqual(await visible(page), ["FJ21.E8"]);
  await page.getByLabel("Search").fill("");
  await page.getByLabel("Only with").check();
  assert.deepEqual(await visible(page), claims.filter((claim) => claim.hypotheses.some(({ stated }) => !stated)).map((claim) => claim.id));
  await page.getByLabel("Status", { exact: true }).selectOption("Proved");
  assert.deepEqual(await visible(page), claims.filter((claim) => !claim.as_printed && claim.status === "Proved").map((claim) => claim.id));
  await page.context().close();
});

test("a claim opens to its engines, whose commands run", async () => {
  const { page } = await openPage(browser, file);
  const card = page.locator('[id="FJ07.4"]');
  await card.locator("summary").click();
  await card.locator("tbody tr").first().waitFor();
  const claim = claims.find(({ id }) => id === "FJ07.4") as Claim;
  const rows = await card.locator("tbody tr").evaluateAll((list) => list.map((row) => [...row.children].map((cell) => cell.textContent ?? "")));
  assert.deepEqual(rows.map((row) => row[0]), claim.engines.map((finding) => finding.engine));
  assert.deepEqual(rows.map((row) => row[4]), claim.engines.map((finding) => finding.detail));
  const command = await card.locator("tbody code").first().textContent();
  assert.match(torse((command ?? "").split(" ").slice(1)), /1 claims: 1/);
  await page.context().close();
});

test("works by keyboard: the link to the content comes first, a claim opens with Enter", async () => {
  const { page } = await openPage(browser, file);
  const focused = () => page.evaluate(() => document.activeElement?.id || document.activeElement?.textContent || "");
  await page.keyboard.press("Tab");
  assert.equal(await focused(), "Skip to the content");
  await page.keyboard.press("Enter");
  assert.equal(await focused(), "content");
  await page.locator('[id="FJ07.1"] summary').focus();
  await page.keyboard.press("Enter");
  assert.equal(await page.locator('[id="FJ07.1"] details').getAttribute("open"), "");
  await page.context().close();
});

test("ends with the command that makes it", async () => {
  const { page } = await openPage(browser, file);
  assert.equal(await page.locator("footer code").textContent(), `torse verify --effort quick --json ${json} --html ${html}`);
  await page.context().close();
});

test("prints without controls, in light colours, with every statement", async () => {
  const { page } = await openPage(browser, file, { colorScheme: "dark" });
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator(".filters").isVisible(), false);
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
  assert.ok((await page.pdf({ format: "A4" })).length > 100000);
  await page.context().close();
});

for (const scheme of ["light", "dark"] as const) {
  test(`axe finds nothing wrong, ${scheme}`, async () => {
    // A few claims: axe takes a minute for all.
    const few = join(folder.path, `few-${scheme}.html`);
    torse(["verify", "--effort", "quick", "--claim", "FJ07.C3", "--claim", "BZZ19.11", "--html", few]);
    const { page } = await openPage(browser, few, { colorScheme: scheme });
    await page.locator('[id="FJ07.C3"] summary').click();
    await page.locator('[id="FJ07.C3"] tbody tr').first().waitFor();
    assert.deepEqual(await audit(page), []);
    await page.getByRole("button", { name: "colours" }).click();
    assert.deepEqual(await audit(page), []);
    await page.context().close();
  });
}
