// A body as points of light at its joints and no more (Johansson 1973): what moves can be seen, and no shape.
import { Color, Group, Mesh, MeshStandardMaterial, SphereGeometry } from "three";
import { theme } from "../ui/palette";
import type { Figure } from "../engine/protocol";

/** What joints are called. First match counts. */
const KINDS: [pattern: RegExp, kind: string | null][] = [
  [/thumb|index|middle|ring|pinky|finger|toe/i, null],
  [/hand|wrist/i, "wrist"],
  [/fore_?arm|lower_?arm|elbow/i, "elbow"],
  [/collar|clavicle|shoulder(?!.*arm)/i, "shoulder girdle"],
  [/arm/i, "shoulder"],
  [/foot|ankle/i, "ankle"],
  [/up_?leg|upper_?leg|thigh|(left|right|[lr]_?)_?hip$/i, "hip"],
  [/leg|knee|shin|calf|tibia/i, "knee"],
  [/head/i, "head"],
];
/** With fewer lights nobody sees a body: then all joints have one. */
const FEWEST = 8;
/** Lights so near to each other are one; metres. */
const APART = 0.03;
/** Metres. */
const RADIUS = 0.026;

/** The nodes that carry a light, from the first pose [nodes x 3]. */
export function lightsOf(figure: Figure, joints: readonly string[], pose: Float32Array): number[] {
  const kindOf = (node: number) => {
    const name = (joints[figure.nodes[node]?.joint ?? -1] ?? "").replace(/^.*:/, "").replace(/\s+/g, "_");
    return KINDS.find(([pattern]) => pattern.test(name))?.[1] ?? null;
  };
  const all = figure.nodes.flatMap(({ endSite }, node) => (endSite ? [] : [node]));
  // Some call the upper arm's joint the shoulder; where there is an arm besides, that one is at the shoulder.
  const girdle = all.some((node) => kindOf(node) === "shoulder") ? "shoulder girdle" : null;
  const named = all.filter((node) => kindOf(node) !== null && kindOf(node) !== girdle);
  const chosen = named.length < FEWEST ? all : named;
  const apart = (a: number, b: number) =>
    Math.hypot(pose[3 * a]! - pose[3 * b]!, pose[3 * a + 1]! - pose[3 * b + 1]!, pose[3 * a + 2]! - pose[3 * b + 2]!);
  return chosen.filter((node, i) => chosen.slice(0, i).every((other) => apart(node, other) > APART));
}

export class PointLights {
  readonly group = new Group();
  readonly #nodes: readonly number[];
  readonly #lights: Mesh[];
  readonly #material: MeshStandardMaterial;

  constructor(figure: Figure, joints: readonly string[], pose: Float32Array) {
    this.#nodes = lightsOf(figure, joints, pose);
    // They shine by themselves, whatever light falls on them.
    this.#material = new MeshStandardMaterial({ color: 0x000000, emissive: new Color(theme().ink) });
    const geometry = new SphereGeometry(RADIUS, 16, 12);
    this.#lights = this.#nodes.map(() => new Mesh(geometry, this.#material));
    for (const light of this.#lights) light.frustumCulled = false;
    this.group.add(...this.#lights);
  }

  /** Node positions [nodes x 3]. */
  pose(positions: Float32Array): void {
    this.#lights.forEach((light, i) => light.position.fromArray(positions, 3 * this.#nodes[i]!));
  }

  dispose(): void {
    this.#lights[0]?.geometry.dispose();
    this.#material.dispose();
    this.group.removeFromParent();
  }
}
