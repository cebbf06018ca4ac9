import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

// The wasm package is built beside this folder, not installed.
const wasmPackage = (folder: string) =>
  fileURLToPath(new URL(`../crate/wasm/pkg/${folder}/vcgpdm.js`, import.meta.url));

/** The whole program and the views that need it are loaded when they are opened; scripts/site.mjs counts them by their folder. */
const isLater = (file: string) =>
  /\/src\/(comparison|experiment|figures)\/|\/pkg\/web\/|\/whole(-engine)?\.ts$/.test(file.replaceAll("\\", "/"));
const folder = (later: boolean) => (later ? "assets/on-demand" : "assets");
const output = {
  entryFileNames: ({ facadeModuleId }: { facadeModuleId: string | null }) =>
    `${folder(isLater(facadeModuleId ?? ""))}/[name]-[hash].js`,
  chunkFileNames: ({ moduleIds }: { moduleIds: string[] }) => `${folder(moduleIds.some(isLater))}/[name]-[hash].js`,
  assetFileNames: ({ originalFileNames }: { originalFileNames: string[] }) =>
    `${folder(originalFileNames.some((file) => isLater(`/${file}`)))}/[name]-[hash][extname]`,
};

export default defineConfig({
  // Relative paths: the built folder works from any sub-folder of any static host.
  base: "./",
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
