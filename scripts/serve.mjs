// A static file server like the hosts that the page is made for: its only special header is the content
// security policy.
import { existsSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, sep } from "node:path";
import { gzipSync } from "node:zlib";
import { policy } from "./policy.mjs";

/** @type {Record<string, string>} */
const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".json": "application/json",
  ".webmanifest": "application/manifest+json",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".wasm": "application/wasm",
};

/**
 * Serves a folder below `prefix` ("/" or "/some/where/"), on the first free port from `port` on (0: any).
 * @param {string} folder
 * @param {{ port?: number, prefix?: string, withPolicy?: boolean, before?: (path: string) => unknown,
 * onSend?: (path: string, bytes: number) => void }} [options] a file waits for the promise of `before`;
 * `onSend` gets each file sent and its gzipped size
 */
export async function serve(folder, { port = 0, prefix = "/", withPolicy = true, before, onSend } = {}) {
  const server = createServer(async (request, response) => {
    const path = pathOf(request.url ?? "/");
    const file = path.startsWith(prefix)
      ? join(folder, path.slice(prefix.length), path.endsWith("/") ? "index.html" : "")
      : "";
    if (!file.startsWith(folder + sep) || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404, { "content-type": "text/plain" }).end("not found\n");
      return;
    }
    await before?.(path);
    const zip = /\bgzip\b/.test(String(request.headers["accept-encoding"]));
    const body = zip ? zipped(file) : readFileSync(file);
    response.writeHead(200, {
      "content-type": TYPES[extname(file)] ?? "application/octet-stream",
      "content-length": body.length,
      "cache-control": "no-cache",
      ...(withPolicy && { "content-security-policy": policy }),
      ...(zip && { "content-encoding": "gzip" }),
    });
    response.end(request.method === "HEAD" ? undefined : body);
    onSend?.(path, body.length);
  });
  const taken = await listen(server, port);
  return {
    address: `http://127.0.0.1:${taken}${prefix}`,
    close: () =>
      new Promise((resolve) => {
        server.close(resolve);
        server.closeAllConnections();
      }),
  };
}

/** @type {Map<string, { changed: number, body: Buffer }>} */
const zips = new Map();

/** The gzipped content of a file, compressed once: a browser test asks for the same files at each visit. */
function zipped(/** @type {string} */ file) {
  const changed = statSync(file).mtimeMs;
  let zip = zips.get(file);
  if (zip?.changed !== changed) {
    zip = { changed, body: gzipSync(readFileSync(file)) };
    zips.set(file, zip);
  }
  return zip.body;
}

/** The decoded path of a request; "" when it cannot be decoded. */
function pathOf(/** @type {string} */ url) {
  try {
    return decodeURIComponent(new URL(url, "http://localhost").pathname);
  } catch {
    return "";
  }
}

/** Listens on the first free port and returns it. */
async function listen(/** @type {import("node:http").Server} */ server, /** @type {number} */ first) {
  for (let port = first; ; port++) {
    try {
      await new Promise((resolve, reject) => {
        server.once("error", reject);
        server.listen(port, "127.0.0.1", () => {
          server.off("error", reject);
          resolve(undefined);
        });
      });
      const address = server.address();
      return typeof address === "object" && address ? address.port : port;
    } catch (error) {
      const taken = error instanceof Error && "code" in error && error.code === "EADDRINUSE";
      if (!taken || port >= first + 100) throw error;
    }
  }
}
