import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

// The wasm package is built beside this folder, not installed.
const wasmPackage = (folder: string) => fileURLToPath(new URL(`../crate/pkg/${folder}/vcgpdm.js`, import.meta.url));

/** What a first visit does not load: the whole program and the views that need it. scripts/site.mjs counts it by its folder. */
const output = {
  entryFileNames: ({ name }: { name: string }) => (name === "comparer" ? "assets/on-demand/[name]-[hash].js" : "assets/[name]-[hash].js"),
  chunkFileNames: ({ isDynamicEntry }: { isDynamicEntry: boolean }) => `assets/${isDynamicEntry ? "on-demand/" : ""}[name]-[hash].js`,
  assetFileNames({ names, originalFileNames }: { names: string[]; originalFileNames: string[] }) {
    const later = originalFileNames.some((file) => file.includes("pkg/web/")) || names.some((name) => name.endsWith(".css") && name !== "index.css");
    return `assets/${later ? "on-demand/" : ""}[name]-[hash][extname]`;
  },
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
