import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { leanThree } from "./lean-three.ts";

// The wasm package is built beside this folder, not installed.
const wasmPackage = (folder: string) =>
  fileURLToPath(new URL(`../crate/wasm/pkg/${folder}/vcgpdm.js`, import.meta.url));

/** What is loaded after the first visit's page, by the folder of the site; scripts/site.mjs counts it by that. */
const LATER: [folder: string, of: RegExp][] = [
  // The whole program and the views that need it, when they are opened.
  ["assets/on-demand", /\/src\/(comparison|experiment|figures)\/|\/pkg\/web\/|\/whole(-engine)?\.ts$/],
  // What a visitor of the first view may ask for: what a term means, the method, a file, the chart of a training, two figures.
  [
    "assets/when-asked",
    /\/src\/(live\/.*|terms\/(card|terms)|method\/.*|app\/(stage-files|saving)|training\/runs-table|clips\/(parts-editor|trim-view|trim)|scene\/columns|stage\/columns-view)\.(ts|css)$|\/uplot\//,
  ],
];
const folderOf = (files: readonly string[]) => {
  const plain = files.map((file) => file.replaceAll("\\", "/"));
  return LATER.find(([, of]) => plain.some((file) => of.test(file)))?.[0] ?? "assets";
};
const output = {
  entryFileNames: ({ facadeModuleId }: { facadeModuleId: string | null }) =>
    `${folderOf([facadeModuleId ?? ""])}/[name]-[hash].js`,
  chunkFileNames: ({ moduleIds }: { moduleIds: string[] }) => `${folderOf(moduleIds)}/[name]-[hash].js`,
  assetFileNames: ({ originalFileNames }: { originalFileNames: string[] }) =>
    `${folderOf(originalFileNames.map((file) => `/${file}`))}/[name]-[hash][extname]`,
};

export default defineConfig({
  // Relative paths: the built folder works from any sub-folder of any static host.
  base: "./",
  plugins: [leanThree()],
  resolve: {
    alias: [
      { find: /^vcgpdm$/, replacement: wasmPackage("web") },
      { find: /^vcgpdm\/playground$/, replacement: wasmPackage("playground") },
    ],
  },
  build: { target: "es2022", assetsInlineLimit: 0, chunkSizeWarningLimit: 900, rollupOptions: { output } },
  worker: { format: "es", rollupOptions: { output } },
  server: { fs: { allow: [".."] } },
});
