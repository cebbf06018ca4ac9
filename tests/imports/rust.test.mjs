// The checker of the order of Rust modules (scripts/rust-imports.mjs), on small crates.
import assert from "node:assert/strict";
import { test } from "node:test";
import { circles, linesOfCode, offencesOf, ordersOf, parse, usesOf } from "../../scripts/rust-imports.mjs";

/** @type {Record<string, string>} */
const GP = { "gp/mod.rs": "mod kernel;\npub use kernel::Kernel;", "gp/kernel.rs": "pub struct Kernel;" };

/** The uses of a small crate. */
const uses = (/** @type {Record<string, string>} */ files, tests = false) =>
  usesOf(
    Object.entries(files).map(([file, text]) => parse(file, text)),
    tests,
  );

test("a use leads to the file that defines the name", () => {
  for (const text of [
    "use crate::gp::Kernel;",
    "use crate::{gp::{Kernel as K}};",
    "fn f() { crate::gp::Kernel::new() }",
    "fn f() { assert!(crate::gp::Kernel::new()) }",
    "fn f(x: Vec<crate::gp::Kernel>) -> &'static str {}",
  ])
    assert.deepEqual(uses({ ...GP, "a.rs": text }), ["a.rs > gp/kernel.rs"], text);
  assert.deepEqual(uses({ ...GP, "gp/a.rs": "use super::Kernel;" }), ["gp/a.rs > gp/kernel.rs"]);
  assert.deepEqual(uses({ ...GP, "gp/a.rs": "mod b { use super::super::*; }" }), ["gp/a.rs > gp/mod.rs"]);
});

test("a re-export counts only when the file uses the name", () => {
  assert.deepEqual(uses(GP), []);
  const used = { ...GP, "gp/mod.rs": `${GP["gp/mod.rs"]} fn f(k: Kernel) {}` };
  assert.deepEqual(uses(used), ["gp/mod.rs > gp/kernel.rs"]);
  assert.deepEqual(uses({ ...GP, "a/mod.rs": "pub use crate::gp::Kernel;" }), ["a/mod.rs > gp/kernel.rs"]);
});

test("comments, texts, visibility and other crates do not count", () => {
  const text = `/* crate::gp */ use std::gp; const A: &str = "crate::gp"; pub(super) fn f(c: '\\'') {} // crate::gp`;
  assert.deepEqual(uses({ ...GP, "gp/a.rs": text }), []);
});

test("uses of tests count on request", () => {
  const files = {
    ...GP,
    "a.rs": "#[cfg(test)]\nmod tests { use super::*; use crate::gp::Kernel; }",
    "b/mod.rs": "#[cfg(test)]\nmod tests;",
    "b/tests.rs": "use crate::gp;",
  };
  assert.deepEqual(uses(files), []);
  assert.deepEqual(uses(files, true), ["a.rs > gp/kernel.rs", "b/tests.rs > gp/mod.rs"]);
});

test("finds a circle of any length", () => {
  assert.deepEqual(circles(["a > b", "b > c", "a > c"]), []);
  assert.deepEqual(circles(["a > b", "b > c", "c > d", "d > b"]), ["b -> c -> d -> b"]);
});

test("a module uses itself and earlier lines only, and has a line", () => {
  const [order = assert.fail()] = ordersOf("# Order\na/b\n  base # first\n  left, right\n  top\n");
  const files = ["base.rs", "lib.rs", "new/a.rs", "new/b.rs"];
  const uses = ["top/a.rs > base.rs", "top/a.rs > top/b.rs", "left.rs > right.rs", "base.rs > top/a.rs"];
  assert.deepEqual(offencesOf(order, files, uses), [
    "new is missing in order.txt",
    "left.rs uses right.rs, against order.txt",
    "base.rs uses top/a.rs, against order.txt",
  ]);
  const [within = assert.fail()] = ordersOf("a/b base\n  low\n  high\n");
  const low = ["base/mod.rs > base/high.rs", "base/low/a.rs > base/high.rs", "base/low/a.rs > top/a.rs"];
  assert.deepEqual(offencesOf(within, ["top/a.rs", "base/mod.rs", "base/new.rs", "base/low/a.rs"], low), [
    "new is missing in order.txt",
    "base/low/a.rs uses base/high.rs, against order.txt",
  ]);
});

test("a line of code is neither empty nor a comment", () => {
  assert.equal(linesOfCode("//! Why.\n\nfn f() {\n    // and how\n} // end\n"), 2);
});
