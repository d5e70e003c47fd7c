// Bundle the pages of the package into python/matrixworld/explorer/built, and that of the class
// tournament into tutorials/class_tournament/built.
//
//     npm ci && npm run build
//
// Each page becomes one script and one style sheet. Their first line holds a digest of all sources, so
// that a test can tell built files that are older than their sources.

import { createHash } from "node:crypto";
import { existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import { dirname, join, relative, sep } from "node:path";
import { fileURLToPath } from "node:url";

import { build } from "esbuild";

const HERE = dirname(fileURLToPath(import.meta.url));
const BUILT = "../python/matrixworld/explorer/built";
const TOURNAMENT = "../tutorials/class_tournament";
/** A folder of src with a main.ts is a page; the list has no other place. */
const PAGES = readdirSync(join(HERE, "src")).filter((name) => existsSync(join(HERE, "src", name, "main.ts")));
/** What the pages are built from. The engine is built by itself, see build_engine.py. */
const SOURCES = [
  "src",
  `${TOURNAMENT}/page`,
  "build.mjs",
  "package.json",
  "package-lock.json",
  "tsconfig.json",
];

/** Return all files below a path. */
function files(path) {
  if (!statSync(path).isDirectory()) return [path];
  return readdirSync(path).flatMap((name) => files(join(path, name)));
}

/** Return the digest of paths and contents of the sources; tests/explorer/test_pages.py computes the same. */
function digest() {
  const hash = createHash("sha256");
  const paths = SOURCES.flatMap((source) => files(join(HERE, source)));
  const names = paths.map((path) => relative(HERE, path).split(sep).join("/"));
  for (const name of names.sort()) {
    const content = createHash("sha256")
      .update(readFileSync(join(HERE, name)))
      .digest("hex");
    hash.update(`${name} ${content}\n`);
  }
  return hash.digest("hex");
}

const first_line = `/* built from web/ by "npm run build"; sources ${digest()} */`;

const bundle = (entryPoints, outdir) =>
  build({
    absWorkingDir: HERE,
    entryPoints,
    outdir,
    nodePaths: [join(HERE, "node_modules")], // for sources outside of web/
    bundle: true,
    format: "iife",
    target: ["es2022", "chrome105", "firefox110", "safari16"],
    minify: true,
    lineLimit: 160, // long lines are unreadable in differences
    charset: "utf8",
    legalComments: "none",
    loader: { ".wasm": "binary" },
    banner: { js: first_line, css: first_line },
    logLevel: "info",
  });

await bundle(Object.fromEntries(PAGES.map((page) => [page, `src/${page}/main.ts`])), BUILT);
await bundle({ class: `${TOURNAMENT}/page/main.ts` }, `${TOURNAMENT}/built`);
