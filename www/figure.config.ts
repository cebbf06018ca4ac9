// Bundles `vcgpdm/figure` of the npm package, with three.js, into one file: scripts/figure.mjs.
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

export default defineConfig({
  publicDir: false,
  build: {
    target: "es2022",
    outDir: fileURLToPath(new URL("../crate/wasm/pkg/figure", import.meta.url)),
    emptyOutDir: true,
    modulePreload: false,
    chunkSizeWarningLimit: 900,
    rollupOptions: {
      input: fileURLToPath(new URL("src/stage/model-figure.ts", import.meta.url)),
      preserveEntrySignatures: "strict",
      output: { format: "es", entryFileNames: "figure.js" },
    },
  },
});
