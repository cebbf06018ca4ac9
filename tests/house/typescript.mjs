// What the page's files import. They are formatted, so that lines say enough and no parser is needed.
import { posix } from "node:path";
import { standsIn } from "./rooms.mjs";

/** @typedef {{ from: string, source: string, typesOnly: boolean }} Import */

const STATIC = /^(?:import|export)\s+(type\s+)?(?:([^"';]*?)\s*from\s+)?"([^"]+)"/gm;
const DYNAMIC = /^(.*?)\bimport\(\s*"([^"]+)"\s*\)(\.[A-Z])?/gm;

/** @returns {Import[]} */
export function importsOf(/** @type {string} */ from, /** @type {string} */ text) {
  const imports = [];
  for (const [, type, names, source = ""] of text.matchAll(STATIC)) {
    const values = names?.replace(/[{}]/g, "").split(",") ?? ["all"];
    const typesOnly = type !== undefined || values.every((name) => /^\s*(type\s|$)/.test(name));
    imports.push({ from, source, typesOnly });
  }
  for (const [, before = "", source = "", member] of text.matchAll(DYNAMIC)) {
    const typesOnly = member !== undefined || /^\s*(\/\/|\/?\*)|typeof\s+$/.test(before);
    imports.push({ from, source, typesOnly });
  }
  return imports;
}

/**
 * Which files use which; `files` are all that there are.
 * @param {Import[]} imports
 * @param {Set<string>} files
 */
export function usesOf(imports, files) {
  return (
    imports
      // What is imported as text or as data is no code of the page.
      .filter(({ source }) => source.startsWith(".") && !/\?raw$|\.(json|svg)$/.test(source))
      .map(({ from, source }) => {
        const path = posix.join(posix.dirname(from), source.replace(/\?.*$/, ""));
        const to = [path, `${path}.ts`, `${path}.js`].find((file) => files.has(file));
        if (!to) throw new Error(`${from} imports ${source}, which is not there`);
        return { from, to };
      })
  );
}

/**
 * Imports of packages by those who may not. "import" counts types too, "load" only what remains when the
 * types are gone.
 * @param {Import[]} imports
 * @param {import("./rooms.mjs").Rule[]} rules
 */
export function forbiddenPackages(imports, rules) {
  const forbidden = (/** @type {Import} */ { from, source, typesOnly }) =>
    rules.some(
      ({ verb, places, packages }) =>
        packages.some((name) => source === name || source.startsWith(`${name}/`)) &&
        !(verb === "load" && typesOnly) &&
        !places.some((place) => standsIn(from, place)),
    );
  return imports.filter(forbidden).map(({ from, source }) => `${from} imports ${source}`);
}
