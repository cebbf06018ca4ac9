import { afterEach, expect, it, vi } from "vitest";
import { LARGEST_DOCUMENT } from "./bytes";
import { addressOf, textOfFile } from "./model-file";

afterEach(() => vi.unstubAllGlobals());

const page = "https://example.org/walk/index.html";

it("finds files beside the page and elsewhere on its host", () => {
  expect(addressOf("mine.json", page)).toBe("https://example.org/walk/mine.json");
  expect(addressOf("/models/a b.JSON?v=2", page)).toBe("https://example.org/models/a%20b.JSON?v=2");
  expect(addressOf("https://example.org/x.json", page)).toBe("https://example.org/x.json");
});

it("refuses other hosts, other kinds of addresses, and other files", () => {
  for (const name of [
    "https://example.com/x.json",
    "//example.com/x.json",
    "\\\\example.com/x.json",
    "http://example.org/x.json",
    "data:application/json,{}",
    "blob:https://example.org/x.json",
    "javascript:x.json",
    "https://",
    "notes.txt",
    "x.txt#.json",
  ])
    expect(() => addressOf(name, page), name).toThrow("link: name");
});

const answering = (answer: () => Promise<Response>) => {
  vi.stubGlobal("document", { baseURI: page });
  const fetched = vi.fn(answer);
  vi.stubGlobal("fetch", fetched);
  return fetched;
};

it("reads a file, and follows no redirect", async () => {
  const fetched = answering(async () => new Response("{}"));
  expect(await textOfFile("mine.json")).toBe("{}");
  expect(fetched).toHaveBeenCalledWith("https://example.org/walk/mine.json", {
    redirect: "error",
    signal: expect.any(AbortSignal),
  });
});

it("says that a file is missing or too large, and asks no other host", async () => {
  answering(async () => new Response("", { status: 404 }));
  await expect(textOfFile("mine.json")).rejects.toMatchObject({ problem: { what: "missing", found: "404" } });
  answering(() => Promise.reject(new TypeError("failed to fetch")));
  await expect(textOfFile("mine.json")).rejects.toMatchObject({ problem: { what: "missing", found: "" } });
  const broken = () => new ReadableStream({ pull: (body) => body.error(new Error("no end")) });
  answering(async () => new Response(broken()));
  await expect(textOfFile("mine.json")).rejects.toMatchObject({ problem: { what: "missing", found: "" } });
  const cancel = vi.fn();
  const endless = () =>
    new ReadableStream({ pull: (body) => body.enqueue(new Uint8Array(LARGEST_DOCUMENT)), cancel });
  answering(async () => new Response(endless()));
  await expect(textOfFile("mine.json")).rejects.toMatchObject({ problem: { what: "large" } });
  expect(cancel).toHaveBeenCalled();
  const fetched = answering(async () => new Response("{}"));
  await expect(textOfFile("https://example.com/x.json")).rejects.toMatchObject({ problem: { what: "name" } });
  expect(fetched).not.toHaveBeenCalled();
});
