// The static site in www/dist, and what a visit to it costs.
import { readFileSync } from "node:fs";
import { basename, relative, sep } from "node:path";
import { gzipSync } from "node:zlib";
import { budget } from "./budget.mjs";
import { writeLicences } from "./licences.mjs";
import { views } from "./views.mjs";
import { at, Failure, filesUnder, runModule, whenChanged } from "./run.mjs";

export const dist = at("www", "dist");

export function buildSite() {
  writeLicences();
  const places = [
    "www",
    "crate/wasm/pkg",
    "package-lock.json",
    "scripts/site.mjs",
    "scripts/policy.mjs",
    "scripts/views.mjs",
  ];
  const inputs = filesUnder(
    places.map((place) => at(place)),
    ["node_modules", "dist"],
  );
  return whenChanged("site", { inputs, outputs: [at("www/dist/index.html")] }, () =>
    runModule("vite/bin/vite.js", "build", at("www"), "--logLevel", "warn", "--emptyOutDir"),
  );
}

const kilobytes = (/** @type {number} */ bytes) => `${(bytes / 1000).toFixed(1).padStart(8)} kB`;

/**
 * Prints every file's gzipped size; throws when the site is over its budget. Without `small` the wasm is larger than
 * that of a visit, and is not weighed.
 */
export function weigh({ small = true } = {}) {
  const files = filesUnder([dist])
    .filter((file) => !file.endsWith(".map") && (small || !file.endsWith(".wasm")))
    .map((file) => ({
      name: relative(dist, file).split(sep).join("/"),
      size: gzipSync(readFileSync(file)).length,
    }))
    .sort((a, b) => b.size - a.size);
  const sum = (/** @type {typeof files} */ some) => some.reduce((total, { size }) => total + size, 0);
  const inFolders = (/** @type {string[]} */ ...folders) =>
    files.filter(({ name }) => folders.some((folder) => name.startsWith(folder)));
  /** @type {[name: string, files: typeof files, budget: number][]} */
  const later = [
    ["the Lab, besides", inFolders("assets/lab/"), budget.lab],
    ["later chapters of the story", inFolders("assets/story/"), budget.story],
    // The service worker is loaded when the page is idle, as what registers it.
    ["when asked for", inFolders("assets/when-asked/", "service.js"), budget.whenAsked],
    ["on demand", inFolders("assets/on-demand/", "licences.txt"), budget.onDemand],
    ["study", inFolders("study/"), budget.study],
    ...views.map(
      ({ folder, name, budget }) =>
        /** @type {[string, typeof files, number]} */ ([
          `the view ${name}`,
          inFolders(`assets/${name}/`, `${folder}/`),
          budget,
        ]),
    ),
    ["motion as GLB", inFolders("assets/glb/"), budget.glb],
    ["for teachers", inFolders("assets/teach/"), budget.teach],
  ];
  // A visit loads one language; the largest counts.
  const besides = [...inFolders("assets/de-", "assets/en-").slice(1), ...later.flatMap(([, some]) => some)];
  const first = files.filter((file) => !besides.includes(file));
  const wasm = first.filter(({ name }) => basename(name).endsWith(".wasm"));
  /** @type {[string, number, number][]} */
  const ofFirst = small
    ? [
        ["wasm of a first visit", sum(wasm), budget.wasm],
        ["first visit", sum(first), budget.firstVisit],
      ]
    : [["first visit without wasm", sum(first), budget.firstScripts]];
  /** @type {[string, number, number][]} */
  const sums = [
    ...ofFirst,
    ...later.map(([name, some, limit]) => /** @type {[string, number, number]} */ ([name, sum(some), limit])),
    ["vcgpdm/figure", gzipSync(readFileSync(at("crate/wasm/pkg/figure/figure.js"))).length, budget.figure],
  ];

  const rows = [...[...first, ...besides].map(({ name, size }) => [name, size, ""]), ...sums];
  const width = Math.max(...rows.map(([name]) => String(name).length));
  console.log(`${"gzipped".padStart(width + 13)}`);
  for (const [name, size, limit] of rows) {
    console.log(
      `${String(name).padEnd(width)}  ${kilobytes(Number(size))}${limit ? `  of ${kilobytes(Number(limit)).trim()}` : ""}`,
    );
  }
  for (const [name, size, limit] of sums) {
    if (size > limit)
      throw new Failure(
        `${name}: ${size} bytes, over the budget of ${limit} (scripts/budget.mjs or its entry.ts)`,
      );
    if (size === 0) throw new Failure(`${name}: nothing was found to weigh`);
  }
}
