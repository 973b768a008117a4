// Builds the page and the tests, then runs these with Node's own runner. `npm test -- look` runs the files whose name holds "look",
// `npm test -- look threshold` the tests of them whose name holds "threshold".
// The browser is Chromium: the one that the variable CHROMIUM names, or /usr/bin/chromium.

import * as esbuild from "esbuild";
import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readdirSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { bundle } from "../build.mjs";

const here = dirname(fileURLToPath(import.meta.url));
mkdirSync(join(here, "out"), { recursive: true });
// A folder of its own: two may run at once
const out = mkdtempSync(join(here, "out", "run-"));
await bundle(out);
const chosen = process.argv[2] ?? "";
const tests = readdirSync(here).filter((file) => file.endsWith(".test.ts") && file.includes(chosen));
await esbuild.build({
  entryPoints: tests.map((file) => join(here, file)),
  outdir: out,
  outExtension: { ".js": ".mjs" },
  bundle: true,
  format: "esm",
  platform: "node",
  packages: "external",
  sourcemap: "inline",
});
const { status } = spawnSync(process.execPath, ["--test", ...(process.argv[3] ? [`--test-name-pattern=${process.argv[3]}`] : []), "--test-concurrency=1", "--enable-source-maps", ...tests.map((file) => join(out, file.replace(/\.ts$/, ".mjs")))], { stdio: "inherit" });
rmSync(out, { recursive: true, force: true });
process.exit(status ?? 1);
