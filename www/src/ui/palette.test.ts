import { afterEach, expect, it, vi } from "vitest";

afterEach(() => {
  vi.unstubAllGlobals();
  vi.resetModules();
});

/** The palette of a page that is dark or light. */
async function palette(dark: boolean) {
  vi.stubGlobal("matchMedia", () => ({ matches: dark }));
  return await import("./palette");
}

it("has a colour of a part for styles that turns with the page, and the one of now for drawings", async () => {
  const light = await palette(false);
  const blue = light.partColour(0);
  expect(blue).toBe("light-dark(#0072b2, #3ea3e6)");
  expect(light.partColour(8), "a ninth part begins again").toBe(blue);
  expect(light.partColourNow(0)).toBe("#0072b2");
  vi.resetModules();
  const dark = await palette(true);
  expect(dark.partColour(0)).toBe(blue);
  expect(dark.partColourNow(0)).toBe("#3ea3e6");
  expect(dark.partColourNow(8)).toBe("#3ea3e6");
  expect(dark.partColourNow(0, dark.theme(false)), "a light picture on a dark page").toBe("#0072b2");
  expect(dark.theme(false).ground).toBe(light.theme().ground);
});
