import { describe, expect, it } from "vitest";
import { motionOf, pointBody, pointsOf } from "./point-body";

/** The joints of a walker made of sticks: parent, and the place at rest with y up, in metres. */
const JOINTS: [name: string, parent: string, rest: [number, number, number]][] = [
  ["pelvis", "", [0, 0.95, 0]],
  ["left_hip", "pelvis", [0.1, 0.95, 0]],
  ["left_knee", "left_hip", [0.1, 0.5, 0]],
  ["left_ankle", "left_knee", [0.1, 0.08, 0]],
  ["right_hip", "pelvis", [-0.1, 0.95, 0]],
  ["right_knee", "right_hip", [-0.1, 0.5, 0]],
  ["right_ankle", "right_knee", [-0.1, 0.08, 0]],
  ["chest", "pelvis", [0, 1.4, 0]],
  ["head", "chest", [0, 1.65, 0]],
  ["left_elbow", "chest", [0.35, 1.3, 0]],
  ["left_wrist", "left_elbow", [0.37, 1.02, 0]],
];
const names = JOINTS.map(([name]) => name);

/** The walker after a time: each bone of a limb swings about the x axis, and keeps its length. */
function walker(time: number): number[][] {
  const places = new Map<string, number[]>();
  for (const [i, [name, parent, rest]] of JOINTS.entries()) {
    const start = places.get(parent);
    const from = JOINTS.find(([other]) => other === parent)?.[2];
    if (!start || !from) {
      places.set(name, [0, rest[1], 1.3 * time]);
      continue;
    }
    const side = name.startsWith("left") ? 1 : -1;
    const limb = /knee|ankle|elbow|wrist/.test(name);
    const angle = limb ? side * (0.5 + 0.05 * i) * Math.sin(6 * time + 0.3 * i) : 0;
    const [x, y, z] = rest.map((value, k) => value - from[k]!) as [number, number, number];
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    places.set(name, [start[0]! + x, start[1]! + c * y - s * z, start[2]! + s * y + c * z]);
  }
  return names.map((name) => places.get(name)!);
}

/** Rows of the walker in the axes and units of a recorder; measured with a little noise. */
function recorded(turned: (at: number[]) => number[], extra: number[] = []): Float64Array {
  const noise = (k: number) => 0.0005 * Math.sin(12.9898 * k);
  return Float64Array.from(
    Array.from({ length: 90 }, (_, row) => [
      ...walker(row / 30).flatMap((at, joint) =>
        turned(at.map((value, k) => value + noise(row * 40 + 3 * joint + k))),
      ),
      ...extra,
    ]).flat(),
  );
}

const columns = names.flatMap((name) => ["x", "y", "z"].map((axis) => `${name}.${axis}`));
const parts = [
  { name: "lower", joints: [...Array(21).keys()] },
  { name: "upper", joints: [...Array(12).keys()].map((k) => 21 + k) },
];

describe("a body of points", () => {
  it("has the points of which all three coordinates are columns, in any order", () => {
    const table = [
      "hand.y",
      "hand.x",
      "time_stamp",
      "hand.z",
      "foot_x",
      "foot_y",
      "nose X",
      "nose Y",
      "nose Z",
    ];
    expect(pointsOf(table)).toEqual([
      { name: "hand", at: [1, 0, 3] },
      { name: "nose", at: [6, 7, 8] },
    ]);
  });

  it("is joined by the bones that were made, with the colours of the parts", () => {
    const body = pointBody(
      { columns, parts },
      recorded((at) => at),
    )!;
    const bones = body.figure.nodes.map(({ parent }, node) => [
      body.points[node]!.name,
      parent === null ? "" : body.points[parent]!.name,
    ]);
    expect(Object.fromEntries(bones)).toEqual(Object.fromEntries(JOINTS));
    expect(body.parts.map(({ name, joints }) => [name, joints.length])).toEqual([
      ["lower", 7],
      ["upper", 4],
    ]);
  });

  it.each([
    ["metres, y up", (at: number[]) => at],
    ["millimetres, z up (Human3.6M)", ([x, y, z]: number[]) => [1000 * x!, -1000 * z!, 1000 * y!]],
    ["y down (mediapipe)", ([x, y, z]: number[]) => [x!, -y!, -z!]],
    ["x up", ([x, y, z]: number[]) => [y!, -x!, z!]],
  ])("stands upright and is not mirrored: %s", (_, turned) => {
    const values = recorded(turned);
    const body = pointBody({ columns, parts }, values)!;
    const { positions, frames, nodes } = motionOf(body, values, columns.length, 1 / 30);
    expect([frames, nodes]).toEqual([90, 11]);
    const at = (name: string, frame = 0) => {
      const start = 3 * (frame * nodes + body.points.findIndex((point) => point.name === name));
      return positions.subarray(start, start + 3);
    };
    expect(at("head")[1]! - at("left_ankle")[1]!).toBeCloseTo(1.7, 0);
    expect(Math.max(...positions.subarray(0, 33))).toBeLessThan(3);
    // Left is at the left of a body that walks: up x forward.
    const way = at("pelvis", 89).map((value, k) => value - at("pelvis")[k]!);
    const left = at("left_hip").map((value, k) => value - at("right_hip")[k]!);
    expect(way[2]! * left[0]! - way[0]! * left[2]!).toBeGreaterThan(0);
  });

  it("is not seen in columns whose points do not keep their distances", () => {
    const random = Float64Array.from({ length: 90 * 33 }, (_, k) => Math.sin(78.233 * k * k));
    expect(pointBody({ columns, parts }, random)).toBeNull();
    expect(
      pointBody(
        { columns: columns.slice(0, 9), parts },
        recorded((at) => at),
      ),
    ).toBeNull();
    expect(pointBody({ columns, parts }, new Float64Array(columns.length * 5))).toBeNull();
    const rotations = ["Hips.yaw_rate", ...columns.slice(1)];
    expect(
      pointBody(
        { columns: rotations, parts },
        recorded((at) => at),
      ),
    ).toBeNull();
  });

  it("ignores the other columns", () => {
    const values = recorded((at) => at, [0.3, 7]);
    const body = pointBody({ columns: [...columns, "visibility", "force.x"], parts }, values)!;
    expect(body.points).toHaveLength(11);
    expect(motionOf(body, values, columns.length + 2, 0.1).frames).toBe(90);
  });
});
