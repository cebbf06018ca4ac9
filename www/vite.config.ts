import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
/// <reference types="vitest/config" />
import { defineConfig, type Plugin } from "vite";
import { policy } from "../scripts/policy.mjs";
import { filesUnder } from "../scripts/run.mjs";
import { views } from "../scripts/views.mjs";
import { offline } from "./offline.ts";

// The wasm package is built next to this folder and not installed.
const wasmPackage = (file: string) => fileURLToPath(new URL(`../crate/wasm/pkg/${file}`, import.meta.url));

/** What a visitor of the Lab may ask for, in `src`: files without extension, and whole folders. */
const WHEN_ASKED = [
  "app/help",
  "app/saving",
  "app/holdings",
  "app/stage-files",
  "clips/parts-editor",
  "clips/trim",
  "clips/trim-view",
  "couplings/model-file",
  "latents/outlook",
  "latents/outlook-drawing",
  "latents/outlook-store",
  "details/",
  "latents/push-handle",
  "completing/",
  ...["live-view", "strip", "recorded-parts"].map((name) => `live/${name}`),
  "offline/service-workers",
  "session/",
  "stage/columns-view",
  "terms/card",
  "terms/terms",
  "training/bound-drawing",
  "training/runs-table",
  "ui/dialog",
  "clips/part-names",
  "unsaved/choice-dialog",
  "ui/checks",
  "words/terms",
  ...["completing", "help", "numbers", "session", "terms"].flatMap((name) => [
    `words/en/${name}`,
    `words/de/${name}`,
  ]),
];
/** The chapters of the story after the first, what only they share, live motions and what visitors make of them. */
const isChapter = (file: string) =>
  /\/src\/(story\/((?!hand\/)[a-z]+\/|endless-walk\.|guessed-chapter\.)|live\/|app\/film\.|words\/(en|de)\/(replies|performing)\.)/.test(
    file,
  );
const isAsked = (file: string) =>
  WHEN_ASKED.some((name) =>
    name.endsWith("/") ? file.includes(`/src/${name}`) : file.includes(`/src/${name}.`),
  );
/** The whole program and the views that need it, when they are opened. */
const isOnDemand = (file: string) =>
  /\/src\/(figures\/|app\/film-gif\.|live\/handles-)|\/node_modules\/modern-|\/training\/progress-|\/app\/any-model\.|\/ui\/two-columns|\/pkg\/web\/|\/whole(-engine|-desk)?\.ts$/.test(
    file,
  );
/** The Lab, and what it shares with chapters of the story. A first visit loads none of it. */
const isLab = (file: string) =>
  /\/src\/(app\/(page|lab-view)|words\/(en|de)\/lab|couplings\/coupling-(view|slider))\.|\/src\/(latents|picture)\//.test(
    file,
  );
/** The page for teachers with its words, the codes in squares, and links with a model in them. */
const isTeaching = (file: string) =>
  /\/src\/(teach|exercises|links|app\/(linked-model|code)|words\/(en|de)\/(teach|links))|\/node_modules\/qr\//.test(
    file,
  );

/** Tests that replace modules or globals of the page: each loads modules of its own. The others share theirs. */
const alone = filesUnder([fileURLToPath(new URL("src", import.meta.url))]).filter(
  (file) =>
    file.endsWith(".test.ts") && /vi\.(mock|stubGlobal)|customElements/.test(readFileSync(file, "utf8")),
);

type Later = [folder: string, of: (file: string) => boolean];

/**
 * What is loaded after the first visit's page, by the folder of the site; scripts/site.mjs counts it by that.
 */
const LATER: Later[] = [
  ["assets/teach", isTeaching],
  // The Lab names all views.
  ["assets/lab", (file) => file.includes("/src/views/")],
  ...views.map(({ folder, name }): Later => [`assets/${name}`, (file) => file.includes(`/src/${folder}/`)]),
  ["assets/glb", (file) => file.includes("/src/scene/glb.")],
  ["assets/on-demand", isOnDemand],
  ["assets/when-asked", isAsked],
  ["assets/story", isChapter],
  ["assets/lab", isLab],
];
const folderOf = (files: readonly string[]) => {
  const plain = files.map((file) => file.replaceAll("\\", "/"));
  return LATER.find(([, of]) => plain.some(of))?.[0] ?? "assets";
};
const SHARED_STYLES = [
  ["latent-view", "assets/story"],
  ["wheel-view", "assets/story"],
  ["coupling-slider", "assets/lab"],
];
const output = {
  entryFileNames: ({ facadeModuleId }: { facadeModuleId: string | null }) =>
    `${folderOf([facadeModuleId ?? ""])}/[name]-[hash].js`,
  chunkFileNames: ({ moduleIds }: { moduleIds: string[] }) => `${folderOf(moduleIds)}/[name]-[hash].js`,
  // Styles that chunks share come without the files that they are made of.
  assetFileNames: ({ originalFileNames, names }: { originalFileNames: string[]; names: string[] }) => {
    const [, folder = folderOf(originalFileNames.map((file) => `/${file}`))] =
      SHARED_STYLES.find(([style]) => names.includes(`${style}.css`)) ?? [];
    return `${folder}/[name]-[hash][extname]`;
  },
};

/** Not for `vite dev`, whose style sheets are inline. */
const heldToPolicy: Plugin = {
  name: "content-security-policy",
  apply: "build",
  transformIndexHtml: () => [
    {
      tag: "meta",
      attrs: { "http-equiv": "Content-Security-Policy", content: policy },
      injectTo: "head-prepend",
    },
  ],
};

/** The icon in the page itself, because browsers ask for its file twice. */
const icon: Plugin = {
  name: "icon",
  transformIndexHtml() {
    const svg = readFileSync(new URL("public/favicon.svg", import.meta.url), "utf8").trim();
    const href = `data:image/svg+xml,${svg.replaceAll('"', "'").replaceAll("#", "%23")}`;
    return [{ tag: "link", attrs: { rel: "icon", href } }];
  },
};

export default defineConfig({
  // Relative paths: the built folder works from any sub-folder of any static host.
  base: "./",
  define: { VIEW_NAMES: JSON.stringify(views.map(({ name }) => name)) },
  plugins: [heldToPolicy, icon, offline()],
  resolve: {
    alias: [
      // Without `train` and without the address of the wasm: the page has workers and a loader of its own.
      { find: /^vcgpdm$/, replacement: wasmPackage("web/glue.js") },
      { find: /^vcgpdm\/player$/, replacement: wasmPackage("player/glue.js") },
      // For tests: Node reads no wasm from an address.
      { find: /^vcgpdm\/inline$/, replacement: wasmPackage("inline/vcgpdm.js") },
    ],
  },
  build: { target: "es2022", assetsInlineLimit: 0, chunkSizeWarningLimit: 900, rollupOptions: { output } },
  // Threads start in half the time of processes.
  test: {
    // Tests of the page start one program for all its workers.
    alias: { "vcgpdm/player": wasmPackage("web/glue.js") },
    setupFiles: ["src/words/lab.setup.ts"],
    pool: "threads",
    projects: [
      { extends: true, test: { name: "together", exclude: alone, isolate: false } },
      { extends: true, test: { name: "alone", include: alone } },
    ],
  },
  worker: { format: "es", rollupOptions: { output } },
  server: { fs: { allow: [".."] } },
});
