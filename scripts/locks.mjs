// Each package in a lock file has a hash of its content, so that a registry cannot send another package.
import { readFileSync } from "node:fs";
import { at, Failure } from "./run.mjs";

const read = (/** @type {string} */ file) => readFileSync(at(file), "utf8");

export async function checkLocks() {
  /** @type {[string, { link?: boolean, integrity?: string }][]} */
  const npm = ["package-lock.json", "tools/page-imports/package-lock.json"].flatMap((file) =>
    Object.entries(JSON.parse(read(file)).packages),
  );
  const cargo = ["Cargo.lock", "crate/python/Cargo.lock", "fuzz/Cargo.lock"]
    .flatMap((file) => read(file).split("[[package]]"))
    .filter((text) => text.includes("\nsource = "));
  const without = [
    // The project and its workspace do not come from a registry.
    ...npm.filter(([path, { link, integrity }]) => path.includes("node_modules/") && !link && !integrity),
    ...cargo.filter((text) => !/^checksum = "\w{64}"$/m.test(text)).map((text) => text.match(/name = .*/)),
  ].map((found) => found?.[0]);
  if (without.length > 0) throw new Failure(`lock files: no hash for ${without.join(", ")}`);
}
