// How quickly pages open and move: node web/bench/measure.mjs PROGRAM writes a table to the standard output.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
const program = resolve(process.argv[2] ?? join(root, "build/release/torse"));
const folder = mkdtempSync(join(tmpdir(), "torse-measure-"));
const opens = 7;

function page(name, words) {
  const path = join(folder, `${name}.html`);
  spawnSync(program, [...words, "--html", path], { cwd: root });
  return path;
}

/** The ledger again and again until it has so many claims, each with its own id, and the surfaces of another page. */
function enlarged(ledger, surfaces, count) {
  const text = readFileSync(ledger, "utf8");
  const place = /(id="report">)([^]*?)(<\/script>)/;
  const report = JSON.parse(place.exec(text)[2]);
  const data = report.sections[0].data;
  data.claims = Array.from({ length: count }, (_, i) => ({ ...data.claims[i % data.claims.length], id: `${data.claims[i % data.claims.length].id}.${i}` }));
  report.sections = [report.sections[0], JSON.parse(place.exec(readFileSync(surfaces, "utf8"))[2]).sections[0]];
  const path = join(folder, "enlarged.html");
  writeFileSync(path, text.replace(place, (_, open, __, close) => open + JSON.stringify(report).replaceAll("<", "\\u003c") + close));
  return path;
}

const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];

/** Milliseconds until the page can be read, until nothing waits any more, and of the frames while it scrolls to its end. */
async function measure(browser, path) {
  const readable = [];
  const complete = [];
  let frames = [];
  for (let i = 0; i < opens; ++i) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
    const tab = await context.newPage();
    await tab.goto(pathToFileURL(path).href);
    await tab.waitForFunction(() => document.documentElement.dataset.idle === "true");
    complete.push(await tab.evaluate(() => performance.now()));
    readable.push(await tab.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? NaN));
    if (i === opens - 1) {
      frames = await tab.evaluate(async () => {
        const times = [];
        let before = performance.now();
        for (let y = 0; y < document.body.scrollHeight; y += 250) {
          scrollTo(0, y);
          await new Promise(requestAnimationFrame);
          times.push(performance.now() - before);
          before = performance.now();
        }
        return times;
      });
    }
    await context.close();
  }
  return { readable: median(readable), complete: median(complete), frame: median(frames), slowest: Math.max(...frames) };
}

const browser = await chromium.launch({
  executablePath: "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"],
});
const samples = readdirSync(join(root, "tests/golden/samples")).filter((name) => /^check-\d+.*\.json$/.test(name)).slice(0, 20);
const ledger = page("verify", ["verify", "--effort", "quick"]);
const surfaces = page("check", ["check", ...samples.map((name) => join("tests/golden/samples", name))]);
const pages = {
  "`torse verify`": ledger,
  "`torse check`, 20 surfaces": surfaces,
  "`torse fit examples/cubics.json`": page("fit", ["fit", "examples/cubics.json", "-o", join(folder, "out.json")]),
  "`torse figures`": page("figures", ["figures"]),
  "200 claims and 20 surfaces": enlarged(ledger, surfaces, 200),
};
console.log("| page | KiB | readable, ms | complete, ms | a frame while scrolling, ms | the slowest frame, ms |\n|---|---|---|---|---|---|");
for (const [name, path] of Object.entries(pages)) {
  const { readable, complete, frame, slowest } = await measure(browser, path);
  console.log(`| ${name} | ${Math.round(statSync(path).size / 1024)} | ${[readable, complete, frame, slowest].map(Math.round).join(" | ")} |`);
}
await browser.close();
rmSync(folder, { recursive: true, force: true });
