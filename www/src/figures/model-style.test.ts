import { expect, it } from "vitest";
import { LOOKS, modelStyle } from "./model-style";
import type { ModelKind } from "../engine/whole-protocol";

type Triple = [number, number, number];

/** Linear red, green and blue of "#rrggbb". */
function linear(colour: string): Triple {
  const channel = (at: number) => {
    const value = Number.parseInt(colour.slice(at, at + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  };
  return [channel(1), channel(3), channel(5)];
}

const times = (matrix: Triple[], [a, b, c]: Triple) =>
  matrix.map(([x, y, z]) => x * a + y * b + z * c) as Triple;

/** Contrast as WCAG defines it. */
function contrast(a: string, b: string): number {
  const luminance = (colour: string) => times([[0.2126, 0.7152, 0.0722]], linear(colour))[0];
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

/** A colour as people without one kind of cone see it: Machado, Oliveira and Fernandes 2009, severity 1. */
const EYES: Record<string, Triple[]> = {
  normal: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protan: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deutan: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritan: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

function oklab(colour: Triple): Triple {
  const cones = times(
    [
      [0.4122214708, 0.5363325363, 0.0514459929],
      [0.2119034982, 0.6806995451, 0.1073969566],
      [0.0883024619, 0.2817188376, 0.6299787005],
    ],
    colour.map((value) => Math.max(0, value)) as Triple,
  ).map(Math.cbrt) as Triple;
  return times(
    [
      [0.2104542553, 0.793617785, -0.0040720468],
      [1.9779984951, -2.428592205, 0.4505937099],
      [0.0259040371, 0.7827717662, -0.808675766],
    ],
    cones,
  );
}

const IDS = Object.keys(LOOKS) as ModelKind[];
const PAIRS = IDS.flatMap((a, i) => IDS.slice(i + 1).map((b) => [a, b] as const));

it.each([
  ["light", ["#ffffff", "#f3f2ef"]],
  ["dark", ["#171b1f", "#101316"]],
] as const)("stands out on the %s page", (shade, grounds) => {
  for (const id of IDS)
    for (const ground of grounds)
      expect(contrast(LOOKS[id][shade], ground), `${id} on ${ground}`).toBeGreaterThanOrEqual(3);
});

it.each(Object.keys(EYES))("can be told from each other: %s", (eye) => {
  for (const shade of ["light", "dark"] as const) {
    for (const [a, b] of PAIRS) {
      const [p, q] = [a, b].map((id) => oklab(times(EYES[eye]!, linear(LOOKS[id][shade])))) as [
        Triple,
        Triple,
      ];
      expect(Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), `${a} and ${b}, ${shade}`).toBeGreaterThan(
        0.1,
      );
    }
  }
});

it("has a name, a colour and a mark of its own for each model", () => {
  const styles = IDS.map(modelStyle);
  for (const key of ["name", "colour", "mark"] as const)
    expect(new Set(styles.map((style) => style[key])).size).toBe(IDS.length);
  expect(modelStyle("vcgpdm")).toEqual({
    name: "vCGPDM",
    colour: "light-dark(#075cb1, #639bdb)",
    mark: "circle",
  });
});
