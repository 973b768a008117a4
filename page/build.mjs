// Writes the bundle that the command embeds: crates/tomolith-report/page/page.js and page.css.
// Versions are exact and esbuild's output depends on its input alone, so the same sources give the same bytes.
// `node build.mjs --watch` builds again at every change.

import * as esbuild from "esbuild";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "../crates/tomolith-report/page");

const options = {
  absWorkingDir: here,
  entryPoints: { page: "src/main.ts" },
  outdir: out,
  bundle: true,
  minify: true,
  format: "iife",
  target: ["es2022", "chrome100", "firefox113", "safari16.4"],
  charset: "utf8",
  legalComments: "none",
  logLevel: "info",
};

if (process.argv.includes("--watch")) {
  await (await esbuild.context(options)).watch();
} else {
  await esbuild.build(options);
  // The page stands inside <script> and <style> elements: nothing in it may end them, and nothing may be loaded from outside.
  for (const [file, forbidden] of [["page.js", /<\/script|<!--|\beval\(/i], ["page.css", /<\/style|url\(|@import/i]]) {
    const found = readFileSync(join(out, file), "utf8").match(forbidden);
    if (found) throw new Error(`${file} contains ${found[0]}`);
  }
}
