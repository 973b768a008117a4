// Writes the bundle that the command embeds: crates/tomolith-report/page/page.js and page.css.
// Versions are exact and esbuild's output depends on its input alone, so the same sources give the same bytes.
// `node build.mjs --watch` builds again at every change.

import * as esbuild from "esbuild";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));

const shared = {
  absWorkingDir: here,
  bundle: true,
  minify: true,
  format: "iife",
  target: ["es2022", "chrome100", "firefox113", "safari16.4"],
  charset: "utf8",
  legalComments: "none",
};

/** `import source from "worker:./file.ts"`: the bundled program as text. */
const workers = {
  name: "workers",
  setup(build) {
    build.onResolve({ filter: /^worker:/ }, ({ path, resolveDir }) => ({ path: join(resolveDir, path.slice("worker:".length)), namespace: "worker" }));
    build.onLoad({ filter: /.*/, namespace: "worker" }, async ({ path }) => {
      const built = await esbuild.build({ ...shared, entryPoints: [path], write: false });
      return { contents: built.outputFiles[0].text, loader: "text", watchFiles: [path] };
    });
  },
};

function options(outdir) {
  return { ...shared, entryPoints: { page: "src/main.ts" }, outdir, plugins: [workers] };
}

/** Writes page.js and page.css into a folder. */
export async function bundle(outdir) {
  await esbuild.build(options(outdir));
  // They stand inside <script> and <style> elements: nothing in them may end these, and nothing may be loaded from outside
  for (const [file, forbidden] of [["page.js", /<\/script|<!--|\beval\(/i], ["page.css", /<\/style|url\(|@import/i]]) {
    const found = readFileSync(join(outdir, file), "utf8").match(forbidden);
    if (found) throw new Error(`${file} contains ${found[0]}`);
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const committed = join(here, "../crates/tomolith-report/page");
  if (process.argv.includes("--watch")) await (await esbuild.context({ ...options(committed), logLevel: "info" })).watch();
  else await bundle(committed);
}
