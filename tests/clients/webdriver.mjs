// A small client of the WebDriver protocol: starts a driver and its browser, and talks to both by fetch.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createServer } from "node:net";
import { setTimeout as sleep } from "node:timers/promises";

/** The key under which WebDriver hands out elements. */
const ELEMENT = "element-6066-11e4-a52e-4f735466cecf";

async function freePort() {
  const server = createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  server.close();
  return port;
}

/**
 * Starts a browser. `driver` is the program that drives it, `capabilities` what WebDriver asks it for.
 * @param {{ driver: string, args?: string[], capabilities: object, env?: NodeJS.ProcessEnv }} options
 */
export async function startBrowser({ driver, args = [], capabilities, env = process.env }) {
  const port = await freePort();
  const child = spawn(driver, [`--port=${port}`, ...args], { env, stdio: "ignore" });
  let base = `http://127.0.0.1:${port}`;

  /** @returns {Promise<any>} */
  async function call(
    /** @type {string} */ method,
    /** @type {string} */ path,
    /** @type {object} */ body = {},
  ) {
    const headers = { "content-type": "application/json" };
    const content = method === "POST" ? { headers, body: JSON.stringify(body) } : {};
    const response = await fetch(`${base}${path}`, { method, ...content });
    const { value } = await response.json();
    if (!response.ok) throw new Error(`${method} ${path}: ${value.error}: ${value.message}`);
    return value;
  }

  async function close() {
    await call("DELETE", "").catch(() => {});
    child.kill();
  }

  try {
    await until("the driver", () => call("GET", "/status").catch(() => false), 20_000);
    const { sessionId } = await call("POST", "/session", { capabilities: { alwaysMatch: capabilities } });
    base += `/session/${sessionId}`;
    await call("POST", "/timeouts", { script: 120_000, pageLoad: 120_000 });
    await call("POST", "/window/rect", { x: 0, y: 0, width: 1280, height: 900 });
  } catch (error) {
    child.kill();
    throw error;
  }

  /** The value of a function that runs in the page; it may return a promise. */
  const run = (/** @type {Function | string} */ script, /** @type {unknown[]} */ ...args) =>
    call("POST", "/execute/sync", { script: `return (${script}).apply(null, arguments)`, args });

  /** The element that a selector finds, when there is one. */
  async function find(/** @type {string} */ selector, timeout = 60_000) {
    const using = { using: "css selector", value: selector };
    const found = () => call("POST", "/element", using).catch(() => null);
    return (await until(selector, found, timeout))[ELEMENT];
  }

  return {
    close,
    run,
    find,
    open: (/** @type {string} */ url) => call("POST", "/url", { url }),
    reload: () => call("POST", "/refresh"),
    /** Clicks as a person does: the browser refuses when something covers the element. */
    async click(/** @type {string} */ selector) {
      const id = await find(selector);
      await until(`a click on ${selector}`, () =>
        call("POST", `/element/${id}/click`).then(
          () => true,
          () => null,
        ),
      );
    },
    /** Drags the handle of a slider by `x` pixels. */
    async drag(/** @type {string} */ selector, /** @type {number} */ x) {
      const origin = { [ELEMENT]: await find(selector) };
      await run((/** @type {Element} */ element) => element.scrollIntoView({ block: "center" }), origin);
      const actions = [
        { type: "pointerMove", origin, x: 0, y: 0 },
        { type: "pointerDown", button: 0 },
        { type: "pointerMove", duration: 200, origin, x, y: 0 },
        { type: "pointerUp", button: 0 },
      ];
      await call("POST", "/actions", { actions: [{ type: "pointer", id: "mouse", actions }] });
    },
    /** Waits until a function in the page returns something true, and returns that. */
    until: (/** @type {string} */ what, /** @type {Function | string} */ script, timeout = 60_000) =>
      until(what, () => run(script), timeout),
  };
}

/** Asks again until the answer is true. */
async function until(/** @type {string} */ what, /** @type {() => Promise<any>} */ ask, timeout = 60_000) {
  const end = performance.now() + timeout;
  for (;;) {
    const answer = await ask();
    if (answer) return answer;
    if (performance.now() > end) throw new Error(`waited ${timeout / 1000} s for ${what}`);
    await sleep(200);
  }
}
