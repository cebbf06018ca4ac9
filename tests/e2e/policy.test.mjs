// The content security policy keeps foreign and inline code out of the page.
import assert from "node:assert/strict";
import { it } from "node:test";
import { policy } from "../../scripts/policy.mjs";

it("the page loads from its own host alone, and does not run text as code", () => {
  const sources = Object.fromEntries(
    policy.split("; ").map((directive) => {
      const [name = "", ...allowed] = directive.split(" ");
      return [name, allowed];
    }),
  );
  for (const name of ["default-src", "style-src", "worker-src", "connect-src", "base-uri"])
    assert.deepEqual(sources[name], ["'self'"], name);
  assert.deepEqual(sources["script-src"], ["'self'", "'wasm-unsafe-eval'"]);
  assert.deepEqual(sources["img-src"], ["'self'", "data:", "blob:"]);
  for (const name of ["object-src", "form-action"]) assert.deepEqual(sources[name], ["'none'"], name);
});
