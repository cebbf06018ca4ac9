import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

// The wasm package is built beside this folder, not installed.
const wasmPackage = fileURLToPath(new URL("../crate/pkg/web/vcgpdm.js", import.meta.url));

export default defineConfig({
  // Relative paths: the built folder works from any sub-folder of any static host.
  base: "./",
  resolve: { alias: { vcgpdm: wasmPackage } },
  build: { target: "es2022", assetsInlineLimit: 0, chunkSizeWarningLimit: 900 },
  worker: { format: "es" },
  server: { fs: { allow: [".."] } },
});
