// Pages that the program writes, opened in Chromium as a person would: from a file, without a network.
//   torse        runs the program          openPage      a page and all that it complains about
//   audit        what axe-core finds wrong with a page
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium, type Browser, type BrowserContextOptions, type Page } from "playwright-core";

const program = process.env["TORSE_PROGRAM"] ?? "";
export const root = process.env["TORSE_ROOT"] ?? "";

/** Runs the program and expects this exit code. */
export function torse(words: string[], code = 0): string {
  const run = spawnSync(program, words, { encoding: "utf8", cwd: root, maxBuffer: 1 << 28 });
  if (run.status !== code) throw new Error(`torse ${words.join(" ")}: exit code ${run.status}\n${run.stdout}${run.stderr}`);
  return run.stdout;
}

export function readJson<T>(path: string): T {
  return JSON.parse(readFileSync(path, "utf8")) as T;
}

/** A folder that is removed at the end. */
export function scratch(): { path: string; remove: () => void } {
  const path = mkdtempSync(join(tmpdir(), "torse-web-"));
  return { path, remove: () => rmSync(path, { recursive: true, force: true }) };
}

/** Chromium, drawing 3D in software; it looks for nothing on the network. */
export async function launch(): Promise<Browser> {
  const path = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find((name) => existsSync(name));
  if (path === undefined) throw new Error("there is no Chromium");
  return chromium.launch({
    executablePath: path,
    timeout: 300000,
    args: [
      "--no-sandbox",
      "--use-gl=angle",
      "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader",
      // Drawing slowly is no sign of a process that hangs.
      "--disable-gpu-watchdog",
      "--disable-hang-monitor",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
    ],
  });
}

export interface Opened {
  page: Page;
  /** Errors and warnings of the console, uncaught errors, and requests that leave the page. */
  complaints: string[];
}

export async function openPage(browser: Browser, path: string, options: BrowserContextOptions = {}): Promise<Opened> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  // As long as it takes: a busy machine is no fault of the page.
  context.setDefaultTimeout(300000);
  const page = await context.newPage();
  const complaints: string[] = [];
  page.on("console", (message) => {
    // Chromium remarks that software draws slowly and that a test reads pixels twice, which is so by our own choice.
    const own = /GPU stall due to ReadPixels|software WebGL|willReadFrequently/.test(message.text());
    if (["error", "warning"].includes(message.type()) && !own) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  const address = pathToFileURL(path).href;
  page.on("request", (request) => {
    if (request.url() !== address && !/^(data|blob):/.test(request.url())) complaints.push(`request: ${request.url()}`);
  });
  await page.goto(address);
  await page.waitForFunction(() => document.documentElement.dataset["idle"] === "true");
  return { page, complaints };
}

/** What axe-core says against a page, a line each. */
export async function audit(page: Page): Promise<string[]> {
  // The page's policy runs no script but its own; a debugger may.
  const source = readFileSync(createRequire(join(root, "web/package.json")).resolve("axe-core/axe.min.js"), "utf8");
  await page.evaluate(source);
  return page.evaluate(async () => {
    const axe = (globalThis as unknown as { axe: { run(): Promise<{ violations: { id: string; nodes: { html: string; failureSummary: string }[] }[] }> } }).axe;
    const { violations } = await axe.run();
    return violations.flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.html} ${node.failureSummary}`));
  });
}
