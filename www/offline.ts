// The service worker of the built page, with the list of all files that it keeps.
import { createHash } from "node:crypto";
import { readdirSync, readFileSync } from "node:fs";
import { join, relative, resolve, sep } from "node:path";
import { build, type Plugin } from "vite";

const SERVICE = "service.js";

/** The files that the service worker keeps, with their revisions. The names of files in assets have a hash already. */
function precachedFiles(folder: string) {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && !entry.name.endsWith(".map") && entry.name !== SERVICE)
    .map((entry) => join(entry.parentPath, entry.name))
    .sort();
  return files.map((file) => {
    const url = relative(folder, file).split(sep).join("/");
    const hasHash = url.startsWith("assets/");
    return {
      url,
      revision: hasHash ? null : createHash("sha256").update(readFileSync(file)).digest("hex").slice(0, 16),
    };
  });
}

export function offline(): Plugin {
  let [root, folder] = ["", ""];
  return {
    name: "offline",
    apply: "build",
    configResolved(config) {
      root = config.root;
      folder = resolve(root, config.build.outDir);
    },
    async closeBundle() {
      await build({
        configFile: false,
        root,
        publicDir: false,
        logLevel: "warn",
        define: { FILES: JSON.stringify(precachedFiles(folder)) },
        build: {
          outDir: folder,
          emptyOutDir: false,
          target: "es2022",
          rollupOptions: {
            input: join(root, "src/offline/service.ts"),
            output: { entryFileNames: SERVICE, format: "iife" },
          },
        },
      });
    },
  };
}
