// A figure of capsules in its parts' colours, posed from node positions.
import {
  Color,
  Group,
  LatheGeometry,
  type Material,
  Mesh,
  MeshStandardMaterial,
  Quaternion,
  SphereGeometry,
  Vector2,
  Vector3,
} from "three";
import { partColour, theme } from "../palette";
import { partOfJoints } from "../parts";
import type { Figure, PartSpec } from "../protocol";
import { type Ball, type Capsule, shapeOf } from "./body-shape";

export type FigureStyle =
  | { kind: "solid" }
  | { kind: "ghost" }
  /** One part in its colour, the others pale. */
  | { kind: "accent"; part: number; opacity: number };

const UP = new Vector3(0, 1, 0);

/** A capsule with a radius for each end, from the origin upwards. */
function taperedCapsule(length: number, r0: number, r1: number): LatheGeometry {
  const outline: Vector2[] = [];
  const rounds = 6;
  for (let i = 0; i <= rounds; i++) {
    const angle = (-0.5 + (0.5 * i) / rounds) * Math.PI;
    outline.push(new Vector2(Math.max(1e-5, r0 * Math.cos(angle)), r0 * Math.sin(angle)));
  }
  for (let i = 0; i <= rounds; i++) {
    const angle = ((0.5 * i) / rounds) * Math.PI;
    outline.push(new Vector2(Math.max(1e-5, r1 * Math.cos(angle)), length + r1 * Math.sin(angle)));
  }
  return new LatheGeometry(outline, 18);
}

export class FigureView {
  readonly group = new Group();
  private bones: { mesh: Mesh; capsule: Capsule }[] = [];
  private balls: { mesh: Mesh; ball: Ball }[] = [];
  private materials: MeshStandardMaterial[] = [];
  private readonly a = new Vector3();
  private readonly b = new Vector3();
  private readonly turn = new Quaternion();

  constructor(
    figure: Figure,
    joints: readonly string[],
    parts: readonly PartSpec[],
    pose: Float32Array,
    style: FigureStyle,
  ) {
    const shape = shapeOf(figure, joints, pose);
    const part = partOfJoints(joints.length, parts as PartSpec[]);
    const materials = new Map<number, MeshStandardMaterial>();
    const materialOf = (joint: number) => {
      const index = part[joint] ?? -1;
      let material = materials.get(index);
      if (!material) {
        material = this.material(index, style);
        materials.set(index, material);
        this.materials.push(material);
      }
      return material;
    };
    for (const capsule of shape.capsules) {
      const mesh = new Mesh(taperedCapsule(capsule.length, capsule.r0, capsule.r1), materialOf(capsule.joint));
      this.bones.push({ mesh, capsule });
      this.add(mesh, style);
    }
    for (const ball of shape.balls) {
      const mesh = new Mesh(new SphereGeometry(ball.radius, 28, 20), materialOf(ball.joint));
      mesh.scale.set(0.88, 1.12, 0.98);
      this.balls.push({ mesh, ball });
      this.add(mesh, style);
    }
  }

  private add(mesh: Mesh, style: FigureStyle): void {
    mesh.castShadow = style.kind === "solid";
    mesh.receiveShadow = style.kind === "solid";
    mesh.frustumCulled = false;
    mesh.renderOrder = style.kind === "solid" ? 0 : 1;
    this.group.add(mesh);
  }

  private material(part: number, style: FigureStyle): MeshStandardMaterial {
    const { ghost } = theme();
    const own = part < 0 ? ghost : partColour(part);
    const look = { roughness: 0.62, metalness: 0 };
    if (style.kind === "solid") return new MeshStandardMaterial({ ...look, color: own });
    const accent = style.kind === "accent" && style.part === part;
    const opacity = style.kind === "ghost" ? 0.34 : accent ? style.opacity : 0.3 * style.opacity;
    return new MeshStandardMaterial({ ...look, color: accent ? own : ghost, transparent: true, opacity });
  }

  /** Fades the whole figure, 0 to 1. */
  fade(opacity: number): void {
    for (const material of this.materials) {
      material.transparent = opacity < 1;
      material.opacity = opacity;
      material.needsUpdate = true;
    }
    for (const { mesh } of [...this.bones, ...this.balls]) mesh.castShadow = opacity > 0.5;
  }

  /** Node positions [nodes x 3]. */
  pose(positions: Float32Array): void {
    for (const { mesh, capsule } of this.bones) {
      this.a.fromArray(positions, 3 * capsule.from);
      this.b.fromArray(positions, 3 * capsule.to).sub(this.a);
      const length = this.b.length();
      if (length > 1e-6) this.turn.setFromUnitVectors(UP, this.b.divideScalar(length));
      mesh.position.copy(this.a);
      mesh.quaternion.copy(this.turn);
    }
    for (const { mesh, ball } of this.balls) {
      mesh.position.fromArray(positions, 3 * ball.node);
      if (ball.towards === null) continue;
      this.b.fromArray(positions, 3 * ball.towards).sub(mesh.position);
      const length = this.b.length();
      if (length > 1e-6) mesh.quaternion.setFromUnitVectors(UP, this.b.clone().divideScalar(length));
      mesh.position.addScaledVector(this.b, 0.5);
    }
  }

  /** Colours again, after a change of theme. */
  dispose(): void {
    for (const { mesh } of [...this.bones, ...this.balls]) mesh.geometry.dispose();
    this.materials.forEach((material: Material) => material.dispose());
    this.group.removeFromParent();
  }
}

export function groundColour(): Color {
  return new Color(theme().ground);
}
