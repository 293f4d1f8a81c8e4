// The pages of torse example and torse figures.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { ExamplesSection } from "../src/report.ts";
import { audit, launch, openPage, readJson, scratch, torse } from "./browser.ts";

const folder = scratch();
const json = join(folder.path, "example.json");
const file = join(folder.path, "example.html");
let browser: Browser;

before(async () => {
  torse(["example", "--json", json, "--html", file]);
  browser = await launch();
});

after(async () => {
  await browser?.close();
  folder.remove();
});

test("printed values stand beside computed ones, as in --json", async () => {
  const { page, complaints } = await openPage(browser, file);
  const { examples } = readJson<ExamplesSection["data"]>(json);
  const rows = await page.$$eval(".example tbody tr", (list) => list.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.deepEqual(
    rows,
    examples.flatMap(({ values }) => values.map(({ label, printed, computed, equal }) => [label, printed, computed, equal ? "equal" : "differs"])),
  );
  assert.equal(rows.length, 50);
  assert.deepEqual(complaints, []);
  assert.deepEqual(await audit(page), []);
  await page.context().close();
});

test("the command at its end makes the same page", async () => {
  const { page } = await openPage(browser, file);
  const command = (await page.locator("footer code").textContent()) ?? "";
  const earlier = readFileSync(file);
  torse(command.split(" ").slice(1));
  assert.ok(readFileSync(file).equals(earlier));
  await page.context().close();
});

test("figures: each has its drawing and its surfaces", async () => {
  const path = join(folder.path, "figures.html");
  torse(["figures", "FJ07", "FJ21", "--html", path]);
  const { page, complaints } = await openPage(browser, path);
  const ids = await page.$$eval("#figures article", (list) => list.map((element) => element.id));
  assert.equal(ids.length, 12);
  assert.equal(ids[0], "FJ07.Fig1");
  await page.locator("#figures article img").first().scrollIntoViewIfNeeded();
  await page.waitForFunction(() => (document.querySelector("#figures img") as HTMLImageElement).naturalWidth > 100);
  const surfaces = await page.$$eval("#figures article", (list) => list.map((element) => element.querySelectorAll("canvas").length));
  assert.ok(surfaces.filter((count) => count > 0).length >= 10);
  assert.deepEqual(complaints, []);
  assert.deepEqual(await audit(page), []);
  await page.context().close();
});
