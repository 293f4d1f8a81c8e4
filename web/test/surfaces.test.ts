// The pages of torse check and torse fit: verdicts and bounds of --json, pictures in 3D that are drawn and turn, names that try to be scripts.
import assert from "node:assert/strict";
import { copyFileSync, readdirSync, statSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Locator, Page } from "playwright-core";
import type { FitSection, Net, Report, Row, SurfacesSection } from "../src/report.ts";
import { audit, launch, openPage, readJson, root, scratch, torse } from "./browser.ts";

const folder = scratch();
const place = (name: string) => join(folder.path, name);
let browser: Browser;

before(async () => {
  const samples = join(root, "tests/golden/samples");
  const files = readdirSync(samples).filter((name) => /^check-\d+.*\.json$/.test(name));
  torse(["check", ...files.map((name) => join("tests/golden/samples", name)), "--json", place("check.json"), "--html", place("check.html")], 1);
  torse(["fit", "examples/cubics.json", "-o", place("cubics.out.json"), "--json", place("fit.json"), "--html", place("fit.html")]);
  torse(["fit", "examples/cubics.json", "--method", "paper", "--ends", "free", "-o", place("open.out.json"), "--json", place("open.json"), "--html", place("open.html")]);
  browser = await launch();
});

after(async () => {
  await browser?.close();
  folder.remove();
});

const reportOf = (page: Page): Promise<Report> => page.evaluate(() => JSON.parse(document.getElementById("report")?.textContent ?? "") as Report);

/** How many different colours a canvas shows when its drawing is done, and a fingerprint of its pixels. */
async function pixels(canvas: Locator): Promise<{ colours: number; sum: number }> {
  await canvas.scrollIntoViewIfNeeded();
  await canvas.and(canvas.page().locator("[data-drawn]")).waitFor();
  return canvas.evaluate(async (element: HTMLCanvasElement) => {
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    // A layout that changes is told to the page between frames, and asks for another drawing.
    for (let drawn = 0; drawn < 5; drawn = element.dataset["drawn"] === undefined ? 0 : drawn + 1) await frame();
    const data = element.getContext("2d")?.getImageData(0, 0, element.width, element.height).data ?? new Uint8ClampedArray();
    const colours = new Set<number>();
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) {
      const value = ((data[i] ?? 0) << 16) | ((data[i + 1] ?? 0) << 8) | (data[i + 2] ?? 0);
      colours.add(value);
      sum = (sum * 31 + value) % 1000000007;
    }
    return { colours: colours.size, sum };
  });
}

/** de Boor's algorithm on homogeneous rows, the papers' knots. */
function deBoor(net: Net, row: Row, t: number): number[] {
  const { degree: n, knots } = net;
  const last = row.weights.length - 1;
  let k = n - 1;
  while (k < last - 1 && t >= (knots[k + 1] as number)) ++k;
  let rows = Array.from({ length: n + 1 }, (_, i) => {
    const at = k - n + 1 + i;
    const w = row.weights[at] as number;
    return [w, ...row.points.slice(3 * at, 3 * at + 3).map((x) => w * x)];
  });
  for (let r = 1; r <= n; ++r) {
    rows = rows.slice(1).map((right, i) => {
      const low = knots[k - n + i + r] as number;
      const high = knots[k + i + 1] as number;
      const share = (t - low) / (high - low);
      return right.map((x, j) => (1 - share) * ((rows[i] as number[])[j] as number) + share * x);
    });
  }
  const [w, ...point] = rows[0] as [number, ...number[]];
  return point.map((x) => x / w);
}

test("check: verdicts, classes and bounds are those of --json", async () => {
  const { page, complaints } = await openPage(browser, place("check.html"));
  const { surfaces } = readJson<SurfacesSection["data"]>(place("check.json"));
  const rows = await page.$$eval("#surfaces table tbody tr", (list) => list.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.equal(rows.length, surfaces.length);
  surfaces.forEach((surface, i) => {
    const [file, outcome, verdict, kind, warp] = rows[i] as string[];
    assert.equal(file, surface.file);
    assert.equal(outcome, surface.developable ? "passed" : "failed");
    assert.equal(verdict, surface.developable ? "developable" : "not developable");
    assert.equal(kind, surface.class);
    const { lo, hi } = surface.max_warp_deg as { lo: number; hi: number };
    assert.deepEqual((warp as string).split(" to ").map(Number), hi === 0 ? [0] : [lo, hi]);
  });
  assert.ok(surfaces.length >= 20);
  assert.ok(statSync(place("check.html")).size < 5 * 1024 * 1024);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("check: sampled rulings lie on the surface of the net in the page", async () => {
  const { page } = await openPage(browser, place("check.html"));
  const section = (await reportOf(page)).sections[0] as SurfacesSection;
  let compared = 0;
  for (const picture of section.pictures) {
    const net = picture?.net;
    const state = picture?.states[0];
    if (net === null || net === undefined || state === undefined) continue;
    const n = net.degree;
    const [begin, end] = [net.knots[n - 1] as number, net.knots[net.knots.length - n] as number];
    state.t.forEach((t, i) => {
      const ruling = state.rulings[i];
      if (ruling === null || ruling === undefined || i % 10 !== 0) return;
      const point = [net.c, net.d].flatMap((row) => deBoor(net, row, begin + t * (end - begin)));
      point.forEach((x, k) => assert.ok(Math.abs(x - (ruling[k] as number)) < 1e-3, `${picture?.name}: ${x} and ${ruling[k]}`));
      ++compared;
    });
  }
  assert.ok(compared > 200, `${compared} rulings`);
  await page.context().close();
});

test("check: every surface is drawn, in one context of WebGL", async () => {
  const { page, complaints } = await openPage(browser, place("check.html"));
  const canvases = page.locator("canvas.scene");
  const count = await canvases.count();
  assert.ok(count >= 20);
  for (let i = 0; i < count; ++i) {
    const { colours } = await pixels(canvases.nth(i));
    assert.ok(colours > 20, `surface ${i} has ${colours} colours`);
  }
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a picture turns by keys and by dragging, and its parts can be switched off", async () => {
  const { page } = await openPage(browser, place("check.html"));
  const card = page.locator("#surface-0");
  const canvas = card.locator("canvas");
  const first = await pixels(canvas);
  await canvas.focus();
  await page.keyboard.press("ArrowRight");
  const turned = await pixels(canvas);
  assert.notEqual(turned.sum, first.sum);
  await page.keyboard.press("0");
  assert.equal((await pixels(canvas)).sum, first.sum);
  const box = await canvas.boundingBox();
  await page.mouse.move((box?.x ?? 0) + 100, (box?.y ?? 0) + 100);
  await page.mouse.down();
  await page.mouse.move((box?.x ?? 0) + 180, (box?.y ?? 0) + 130);
  await page.mouse.up();
  assert.notEqual((await pixels(canvas)).sum, first.sum);
  await card.getByRole("button", { name: "Reset view" }).click();
  for (const name of ["Rulings", "Control net", "Edge of regression"]) {
    const button = card.getByRole("button", { name, exact: true });
    const on = await pixels(canvas);
    await button.click();
    assert.equal(await button.getAttribute("aria-pressed"), "false");
    assert.notEqual((await pixels(canvas)).sum, on.sum, name);
  }
  await page.context().close();
});

test("fit: numbers of --json, before and after", async () => {
  const { page, complaints } = await openPage(browser, place("fit.html"));
  const surface = readJson<FitSection["data"]>(place("fit.json")).surfaces[0];
  assert.ok(surface !== undefined);
  const rows = await page.$$eval(".fit table", (tables) => [...(tables[0]?.querySelectorAll("tbody tr") ?? [])].map((row) => [...row.children].map((cell) => cell.textContent)));
  const pair = (key: "mean_deg" | "rms_deg" | "max_deg") => [surface.before[key].toPrecision(6), surface.after[key].toPrecision(6)];
  assert.deepEqual(rows.map((row) => row.slice(1)), [pair("mean_deg"), pair("rms_deg"), pair("max_deg")]);
  const text = await page.locator(".fit").innerText();
  assert.ok(text.includes(`between ${surface.max_warp_deg.lo} and ${surface.max_warp_deg.hi} degrees`));
  assert.equal(await page.locator(".plot svg").count(), 3);
  const canvas = page.locator("canvas.scene");
  const fitted = await pixels(canvas);
  await page.getByLabel("T = t", { exact: true }).check();
  assert.notEqual((await pixels(canvas)).sum, fitted.sum);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("fit: what is not decided is not certified", async () => {
  assert.equal(readJson<FitSection["data"]>(place("open.json")).surfaces[0]?.self_intersection.crosses, null);
  assert.equal(readJson<FitSection["data"]>(place("fit.json")).surfaces[0]?.self_intersection.crosses, false);
  for (const [name, decided] of [["open.html", false], ["fit.html", true]] as const) {
    const { page } = await openPage(browser, place(name));
    const text = await page.locator(".fit").innerText();
    assert.equal(text.includes("Certified: no two rulings cross."), decided, name);
    assert.equal(text.includes("Whether rulings cross is not decided."), !decided, name);
    await page.context().close();
  }
});

test("fit: a plot has its numbers as a table", async () => {
  const { page } = await openPage(browser, place("fit.html"));
  const state = ((await reportOf(page)).sections[0] as FitSection).pictures[0]?.states[0];
  const plot = page.locator(".plot").nth(1);
  await plot.locator("summary").click();
  const first = await plot.locator("tbody tr").first().innerText();
  assert.deepEqual(first.split(/\s+/).map(Number), [state?.t[0], state?.targets[0]].map((x) => Number((x as number).toPrecision(4))));
  await page.context().close();
});

test("study: a plot for each factor, and the table of the terminal", async () => {
  const text = torse(["study", "growth", "--html", place("study.html")]);
  const { page, complaints } = await openPage(browser, place("study.html"));
  const titles = await page.$$eval(".plot figcaption", (list) => list.map((element) => element.textContent));
  assert.deepEqual(titles, ["Median error in u by pieces", "Median error in u by before"]);
  const rows = await page.$$eval("table tbody tr", (list) => list.map((row) => [...row.children].map((cell) => cell.textContent ?? "")));
  const first = text.split("\n").find((line) => line.startsWith("FJ07.13 "))?.split(/\s+/) ?? [];
  const row = rows.find(([route]) => route === "FJ07.13") ?? [];
  assert.deepEqual(row.slice(0, 2), first.slice(0, 2));
  row.slice(2, 10).forEach((value, i) => assert.equal(Number(Number(value).toPrecision(3)), Number(first[i + 2])));
  assert.deepEqual(complaints, []);
  assert.deepEqual(await audit(page), []);
  await page.context().close();
});

test("a name is a name, whatever is in it", async () => {
  const name = place("a<img src=x onerror=alert(1)>&amp;<!--<script>.json");
  copyFileSync(join(root, "tests/golden/samples/check-04-cone-n2-N1-clamped.json"), name);
  torse(["check", name, "--html", place("name.html")]);
  const { page, complaints } = await openPage(browser, place("name.html"));
  assert.ok((await page.locator("article h3").textContent())?.includes("a<img src=x onerror=alert(1)>&amp;<!--<script>.json"));
  assert.equal(await page.locator("img").count(), 0);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("axe finds nothing wrong with surfaces and plots", async () => {
  for (const colorScheme of ["light", "dark"] as const) {
    for (const name of ["fit.html", "check.html"]) {
      const { page } = await openPage(browser, place(name), { colorScheme });
      assert.deepEqual(await audit(page), [], name);
      await page.context().close();
    }
  }
});
