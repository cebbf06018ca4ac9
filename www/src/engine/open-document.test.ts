import { expect, it } from "vitest";
import { OpenDocument } from "./open-document";
import { Pool } from "./pool";

/** A worker that keeps a document open, and the documents that were sent to all workers. */
function scene() {
  const sent: string[] = [];
  const hire = () => {
    let document = "";
    const worker = {
      open: async (text: string) => {
        sent.push(text);
        if (text === "bad") throw new Error("no document");
        document = text;
        return text.length;
      },
      read: async () => document,
    };
    return { worker, ready: Promise.resolve(), broken: new Promise<never>(() => {}), dismiss: () => {} };
  };
  const pool = new Pool(1, hire);
  return { sent, pool, document: new OpenDocument(pool, (worker, text) => worker.open(text)) };
}

it("sends a document once, and again only for another document", async () => {
  const { sent, document } = scene();
  expect(await document.open("one")).toBe(3);
  for (let i = 0; i < 3; i++) expect(await document.ask("one", (worker) => worker.read())).toBe("one");
  expect(await document.ask("other", (worker) => worker.read())).toBe("other");
  expect(await document.ask("one", (worker) => worker.read())).toBe("one");
  expect(sent).toEqual(["one", "other", "one"]);
});

it("sends it to a fresh worker", async () => {
  const { sent, pool, document } = scene();
  await document.open("one");
  await expect(pool.run(() => Promise.reject(new Error("it died")))).rejects.toThrow("it died");
  expect(await document.ask("one", (worker) => worker.read())).toBe("one");
  expect(sent).toEqual(["one", "one"]);
});

it("keeps no document that could not be opened", async () => {
  const { sent, document } = scene();
  await document.open("one");
  await expect(document.open("bad")).rejects.toThrow("no document");
  await expect(document.ask("bad", (worker) => worker.read())).rejects.toThrow("no document");
  expect(await document.ask("one", (worker) => worker.read())).toBe("one");
  expect(sent).toEqual(["one", "bad", "bad", "one"]);
});
