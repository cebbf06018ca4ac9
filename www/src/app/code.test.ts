import { decodeQR } from "qr/decode.js";
import { expect, it } from "vitest";
import { codeOf, frameLine, LONGEST_CODE } from "./code";

/** Paints a code with some pixels for each module, as a camera sees it. */
function painted({ side, path }: ReturnType<typeof codeOf>, pixels = 4) {
  const width = side * pixels;
  const data = new Uint8ClampedArray(width * width * 4).fill(255);
  for (const [, x = "", y = ""] of path.matchAll(/M(\d+) (\d+)h1v1h-1z/g))
    for (let row = 0; row < pixels; row++)
      for (let column = 0; column < pixels; column++) {
        const first = 4 * ((Number(y) * pixels + row) * width + Number(x) * pixels + column);
        data.fill(0, first, first + 3);
      }
  return { width, height: width, data };
}

it("can be read again", () => {
  const address = "https://example.org/walk/#alpha=0.1:1.119&camera=1.2,0.1,1&time=2.5";
  expect(decodeQR(painted(codeOf(address)))).toBe(address);
});

it("holds as many characters as it says, and no more", () => {
  const longest = "a".repeat(LONGEST_CODE);
  expect(decodeQR(painted(codeOf(longest), 3))).toBe(longest);
  expect(() => codeOf(`${longest}a`)).toThrow();
});

it("writes a frame whose attributes cannot end early", () => {
  const line = frameLine('https://example.org/?embed#alpha=0.1:2&time=1"><b>', 'A "walk"');
  expect(line).toBe(
    '<iframe src="https://example.org/?embed#alpha=0.1:2&amp;time=1&quot;>&lt;b>" title="A &quot;walk&quot;" ' +
      'width="800" height="500" sandbox="allow-scripts allow-same-origin"></iframe>',
  );
});
