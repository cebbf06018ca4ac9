// A body as points of light (Johansson 1973), which show its movement without its shape.
import { Color, Group, Mesh, MeshStandardMaterial, SphereGeometry } from "three";
import { theme } from "../ui/palette";

/** Metres. */
const RADIUS = 0.026;

export class PointLights {
  readonly group = new Group();
  readonly #nodes: readonly number[];
  readonly #lights: Mesh[];
  readonly #geometry = new SphereGeometry(RADIUS, 16, 12);
  /** The material ignores the lights of the scene. */
  readonly #material = new MeshStandardMaterial({ color: 0x000000, emissive: new Color(theme().ink) });

  /** A light at each of these nodes. */
  constructor(nodes: readonly number[]) {
    this.#nodes = nodes;
    this.#lights = nodes.map(() => new Mesh(this.#geometry, this.#material));
    for (const light of this.#lights) light.frustumCulled = false;
    this.group.add(...this.#lights);
  }

  /** Node positions [nodes x 3]. */
  pose(positions: Float32Array): void {
    this.#lights.forEach((light, i) => light.position.fromArray(positions, 3 * this.#nodes[i]!));
  }

  dispose(): void {
    this.#geometry.dispose();
    this.#material.dispose();
    this.group.removeFromParent();
  }
}
