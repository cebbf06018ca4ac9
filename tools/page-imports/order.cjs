// What the files of the page may import. This file is both the document of the order and its check:
// `npm test -- --only imports`.
const { readdirSync } = require("node:fs");
const { join } = require("node:path");
const { views } = require("../../scripts/views.mjs");

const VIEWS = views.map(({ folder }) => folder);
/** The folders of www/src. A folder imports only from lines above its own. */
const ORDER = [
  ["ui"], // what all stores and views are made of. No model
  ["links"], // models in links
  ["words"], // the sentences of the page, one folder for each language
  ["engine", "terms", "offline"], // messages to the workers; the meaning of terms; the service worker
  ["unsaved"], // asks before work is lost
  ["settings"], // settings and the page's address
  ["scene", "figures"], // three.js and skeletons; charts and tables
  ["stage"], // the moving figures and their clock
  ["clips"],
  ["couplings"],
  ["latents"],
  ["completing"], // a recording that moves one part
  ["live"], // the rollout without an end
  ["training"],
  ["picture"], // loops and couplings next to the figure of the Lab
  ["views"], // what a view of the page is; a folder with a file entry.ts is one
  ["details"],
  VIEWS, // a view may use another, without a circle
  ["exercises"], // what a class does in the Lab, and when it is solved
  ["session"], // the copy of a visit in the browser's database
  ["app"], // creates the stores and connects them
  ["teach"], // for teachers: plans, slides, codes
  ["story"], // the first view: its frame, and a folder for each chapter
  ["main"],
  ["workers"], // programs of their own, with the wasm in them
];

/** The only files of other folders that workers may import. */
const FOR_WORKERS = [
  ...["protocol", "whole-protocol", "library-protocol", "series-protocol"],
  ...["limits", "transfers", "traps"],
];

/** The only folders that may import a package. */
const PACKAGES = [
  { packages: ["comlink"], folders: ["engine", "workers"] },
  { packages: ["three"], folders: ["scene", "stage", "comparison", "perception"] },
  { packages: ["jspsych"], folders: ["perception"] },
  { packages: ["qr"], folders: ["app"] },
  { packages: ["idb"], folders: ["session", "perception"] },
  { packages: ["workbox-core", "workbox-precaching", "workbox-window"], folders: ["offline"] },
];

const unlisted = readdirSync(join(__dirname, "../../www/src"))
  .map((name) => name.replace(/\.ts$/, ""))
  .filter((name) => !ORDER.flat().includes(name));
if (unlisted.length > 0) throw new Error(`add to ORDER in ${__filename}: ${unlisted.join(", ")}`);

/** Matches the files in these folders of www/src. */
const inside = (/** @type {string[]} */ folders) => `^www/src/(${folders.join("|")})(/|\\.ts$)`;

/** @type {import("dependency-cruiser").IConfiguration} */
module.exports = {
  forbidden: [
    { name: "no circle", severity: "error", from: {}, to: { circular: true } },
    { name: "file exists", severity: "error", from: {}, to: { couldNotResolve: true, pathNot: "^vcgpdm" } },
    ...ORDER.flatMap((folders, line) =>
      folders.map((folder) => ({
        name: `order of ${folder}`,
        severity: "error",
        // Tests run the workers in their own thread.
        from: { path: inside([folder]), pathNot: "^www/src/engine/held\\.fake\\.ts$" },
        to: { path: "^www/src/", pathNot: inside([...(folders === VIEWS ? VIEWS : [folder]), ...ORDER.slice(0, line).flat()]) },
      })),
    ),
    {
      name: "workers stand alone",
      severity: "error",
      from: { path: inside(["workers"]) },
      to: {
        path: "^www/src/",
        pathNot: [inside(["workers"]), `^www/src/engine/(${FOR_WORKERS.join("|")})\\.ts$`],
      },
    },
    {
      name: "only workers load the wasm",
      severity: "error",
      // Tests compare numbers of the page with the library.
      from: { path: "^www/src/", pathNot: [inside(["workers"]), "\\.fake\\.ts$"] },
      to: { path: "^vcgpdm|^crate/wasm/pkg/", preCompilationOnly: false },
    },
    ...PACKAGES.map(({ packages, folders }) => ({
      name: `only ${folders.join(", ")} import ${packages.join(", ")}`,
      severity: "error",
      from: { path: "^www/src/", pathNot: inside(folders) },
      to: { path: `node_modules/(@types/)?(${packages.join("|")})/` },
    })),
  ],
  options: {
    tsPreCompilationDeps: "specify",
    tsConfig: { fileName: join(__dirname, "../../www/tsconfig.json") },
    enhancedResolveOptions: { exportsFields: ["exports"], conditionNames: ["import", "types", "default"] },
    doNotFollow: { path: "node_modules|crate/wasm/pkg" },
    // JSON, pictures and text are no code of the page.
    exclude: { path: "\\?raw$|\\.(json|svg|md)$" },
  },
};
