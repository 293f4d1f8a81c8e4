// Builds the viewer: one HTML file with style, fonts and script in it, and the place `@report@` for the data.
//   node build.mjs OUT
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2];
if (out === undefined) throw new Error("node build.mjs OUT");

// The families and faces of KaTeX's fonts that statements use.
const usedFonts = /^KaTeX_(Main-Regular|Main-Italic|Main-Bold|Math-Italic|AMS-Regular|Size[1-4]-Regular|Caligraphic-Regular)$/;

/** KaTeX's style sheet with the fonts that are used in it, and no others. */
function katexStyle() {
  const folder = join(here, "node_modules/katex/dist");
  const style = readFileSync(join(folder, "katex.min.css"), "utf8");
  return style.replace(/@font-face\{[^}]*\}/g, (face) => {
    const name = /fonts\/([\w-]+)\.woff2/.exec(face)?.[1];
    if (name === undefined || !usedFonts.test(name)) return "";
    const font = readFileSync(join(folder, "fonts", `${name}.woff2`)).toString("base64");
    return face.replace(/src:[^;}]*/, `src:url(data:font/woff2;base64,${font}) format("woff2")`);
  });
}

/** The text of an entry point with all that it imports. */
async function bundled(entry) {
  const result = await build({
    entryPoints: [join(here, entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2021",
    charset: "utf8",
    legalComments: "inline",
    logLevel: "warning",
  });
  return result.outputFiles[0].text.trim();
}

const style = katexStyle() + (await bundled("src/style.css"));
const script = (await bundled("src/main.ts")).replaceAll("</script", "<\\/script");
const hash = createHash("sha256").update(script).digest("base64");
const policy = [
  "default-src 'none'",
  `script-src 'sha256-${hash}'`,
  "style-src 'unsafe-inline'",
  "font-src data:",
  "img-src data: blob:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

const parts = { policy, style, script };
let page = readFileSync(join(here, "index.html"), "utf8");
for (const [name, text] of Object.entries(parts)) page = page.replace(`@${name}@`, () => text);
if (page.split("@report@").length !== 2) throw new Error("the place of the data must occur once");
mkdirSync(dirname(out), { recursive: true });
writeFileSync(out, page);
console.log(`${out}: ${Math.round(page.length / 1024)} KiB`);
