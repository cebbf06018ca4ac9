// The npm package as a user gets it: packed by npm, installed into an empty folder, loaded from there.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import { pathToFileURL } from "node:url";
import { at } from "../../scripts/run.mjs";

/** A folder in which `vcgpdm` is installed until the tests of a file have ended, and what loading it there gives. */
export async function installedPackage() {
  const folder = mkdtempSync(join(tmpdir(), "vcgpdm-"));
  const npm = (/** @type {string[]} */ ...args) => {
    const cli = process.env.npm_execpath;
    return execFileSync(cli ? process.execPath : "npm", [...(cli ? [cli] : []), ...args], {
      cwd: folder,
      encoding: "utf8",
    });
  };
  writeFileSync(join(folder, "package.json"), '{ "private": true, "type": "module" }\n');
  const tarball = npm("pack", at("crate/wasm/pkg"), "--loglevel=error").trim().split("\n").at(-1) ?? "";
  npm("install", "--offline", "--no-audit", "--no-fund", "--loglevel=error", `./${tarball}`);

  const require = createRequire(join(folder, "user.js"));
  const entry = join(folder, "entry.js");
  writeFileSync(entry, 'export * from "vcgpdm";\nexport { default } from "vcgpdm";\n');
  /** @type {typeof import("vcgpdm")} */
  const vcgpdm = await import(pathToFileURL(entry).href);
  after(() => rmSync(folder, { recursive: true, force: true }));
  return { folder, require, vcgpdm };
}

/** The description of a vCGPDM or vGPDM of a body. */
export const coupledInfo = (/** @type {import("vcgpdm").Model} */ model) =>
  /** @type {import("vcgpdm").CoupledModelInfo} */ (model.info());
