// Runs the tests: node test/run.mjs PROGRAM. Each *.test.ts becomes a module that Node's own runner takes.
import { spawnSync } from "node:child_process";
import { readdirSync, rmSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const program = process.argv[2];
if (program === undefined) throw new Error("node test/run.mjs PROGRAM");

// Below node_modules, so that the modules find their packages.
const out = join(here, "../node_modules/.tests");
rmSync(out, { recursive: true, force: true });
const names = readdirSync(here, { recursive: true }).filter((name) => name.endsWith(".test.ts"));
await build({
  entryPoints: names.map((name) => join(here, name)),
  outbase: here,
  outdir: out,
  outExtension: { ".js": ".mjs" },
  bundle: true,
  platform: "node",
  format: "esm",
  target: "node18",
  packages: "external",
  logLevel: "warning",
});
const files = names.map((name) => join(out, name.replace(/\.ts$/, ".mjs")));
const run = spawnSync(process.execPath, ["--test", "--test-reporter=spec", ...files], {
  stdio: "inherit",
  env: { ...process.env, TORSE_PROGRAM: resolve(program), TORSE_ROOT: join(here, "../..") },
});
process.exit(run.status ?? 1);
