// The first seconds: no error, a moving figure at once, and a small visit.
import assert from "node:assert/strict";
import { after, before, beforeEach, describe, it } from "node:test";
import { budget } from "../../scripts/budget.mjs";
import { policy } from "../../scripts/policy.mjs";
import { changes, draws, often, openSite, ready, rests, seldom } from "./site.mjs";

/** Holds the wasm back until it is released. */
let wasm = Promise.resolve();
let sent = 0;
/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;

before(async () => {
  site = await openSite({
    before: (path) => (path.endsWith(".wasm") ? wasm : undefined),
    // The page loads the whole program when it is idle.
    onSend: (path, bytes) => {
      if (!path.includes("/on-demand/")) sent += bytes;
    },
  });
});
beforeEach(() => {
  wasm = Promise.resolve();
  sent = 0;
});
after(() => site?.close());

describe("a first visit", () => {
  it(`gets ready without an error, without asking another host, in less than ${budget.firstVisit} bytes`, async (test) => {
    const { page, problems, leave } = await site.visit({ story: true, moving: true, seen: true, idle: true });
    await page.locator(".story[data-state=open][data-engine=ready]").waitFor();
    test.diagnostic(`${sent} bytes`);
    // The wasm of `npm test` is a large one.
    assert.ok(sent > 10_000 && (often() || sent < budget.firstVisit), `${sent} bytes`);
    assert.ok(await changes(page.getByTestId("pad-0")), "a pen shows how to draw");
    assert.deepEqual(problems, []);
    await leave();
  });
});

describe("the Lab", () => {
  seldom.it("shows a moving figure before the wasm has arrived, and then that of the model", async () => {
    let release = () => {};
    wasm = new Promise((resolve) => {
      release = resolve;
    });
    const { page, problems, leave } = await site.visit({ moving: true, seen: true });
    const stage = page.getByTestId("stage");
    await draws(stage);
    assert.ok(await changes(stage), "the figure moves");
    await page.getByTestId("play").click();
    assert.ok(await rests(stage), "Pause stops it");
    await page.getByTestId("play").click();
    assert.equal(await page.locator("html").getAttribute("data-engine"), "loading");
    assert.ok(await page.getByTestId("train").isDisabled());
    release();
    await ready(page);
    assert.ok(await changes(stage), "the figure moves on");
    assert.deepEqual(problems, []);
    await leave();
  });

  it("says when the wasm cannot be loaded, and the figure keeps walking", async () => {
    const { page, leave } = await site.visit({ moving: true, seen: true, without: "**/*.wasm" });
    await page.waitForSelector("html[data-engine=failed]");
    await page.getByRole("alert").first().waitFor();
    assert.ok(await changes(page.getByTestId("stage")));
    await leave();
  });

  it("starts paused for visitors who want less motion", async () => {
    const { page, leave } = await site.visit();
    await ready(page);
    await page.getByRole("button", { name: "Play" }).waitFor();
    const frame = await page.getByTestId("scrub").inputValue();
    await page.waitForTimeout(500);
    assert.equal(await page.getByTestId("scrub").inputValue(), frame);
    await leave();
  });
});

describe("in a frame whose sandbox lacks allow-same-origin", () => {
  /** The page in such a frame; `cors`: its host lets every page load its files. */
  async function framed(cors = false) {
    const { page, leave } = await site.visit({ query: "?embed" });
    const url = page.url();
    if (cors)
      await page.route("**/*", async (route) => {
        const response = await route.fetch();
        const headers = { ...response.headers(), "access-control-allow-origin": "*" };
        await route.fulfill({ response, headers });
      });
    await page.setContent(`<iframe sandbox="allow-scripts" width="900" height="600" src="${url}"></iframe>`);
    const frame = page.frameLocator("iframe");
    // Files may still be on their way.
    return { frame, leave: () => page.unrouteAll({ behavior: "ignoreErrors" }).then(leave) };
  }

  it("says that the sandbox keeps it from starting, not that it was opened as a file", async () => {
    const { frame, leave } = await framed();
    await frame.getByText("Add allow-same-origin to the sandbox").waitFor();
    assert.ok(await frame.getByText("opened as a file").isHidden());
    await leave();
  });

  it("shows the stored walk if its host allows that, and says what the model needs", async () => {
    const { frame, leave } = await framed(true);
    await frame.getByText("frame whose sandbox lacks allow-same-origin").waitFor();
    await frame.locator("canvas").first().waitFor();
    await leave();
  });
});

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
