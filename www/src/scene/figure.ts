// A figure of capsules in its parts' colours, posed from node positions.
import {
  AlwaysStencilFunc,
  GreaterStencilFunc,
  Group,
  LatheGeometry,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  ReplaceStencilOp,
  SphereGeometry,
  Vector2,
  Vector3,
} from "three";
import { partColourNow, type Theme, theme } from "../ui/palette";
import { partOfJoints } from "./joints";
import type { Figure, PartSpec } from "../engine/protocol";
import { type Ball, type Capsule, type Shape, shapeOf } from "./body-shape";

export type FigureStyle =
  | { kind: "solid" }
  /** Only the outline. */
  | { kind: "ghost" }
  /** One of several faint figures. */
  | { kind: "future"; index: number }
  /** One part in its colour, the others pale. */
  | { kind: "accent"; part: number; opacity: number };

const UP = new Vector3(0, 1, 0);
/** A trunk is wider than it is deep. */
const TRUNK_WIDTH = [1.42, 1, 0.95] as const;

/** Width of an outline, metres. */
const OUTLINE_WIDTH = 0.01;

/** Stencil values of the pixels of bodies. */
const SOLID = 255;
const PALE = 254;
const OUTLINE = 253;
const FIRST_FUTURE = 1;

/**
 * A body writes its stencil value, and skips pixels with the same or a higher value. So a pale body draws each
 * pixel once, without seams, and never over a solid body. Futures are visible through each other.
 */
function stencil<M extends Material>(material: M, mark: number): M {
  material.stencilWrite = true;
  material.stencilRef = mark;
  material.stencilFunc = mark === SOLID ? AlwaysStencilFunc : GreaterStencilFunc;
  material.stencilZPass = ReplaceStencilOp;
  return material;
}

/**
 * The materials of an outline: the body itself without a colour, and a thicker body around it, of which only
 * the rim is drawn.
 */
function outline({ quiet }: Theme): { body: Material; rim: Material } {
  const rim = new MeshBasicMaterial({ color: quiet, transparent: true, depthWrite: false });
  const body = new MeshBasicMaterial({ colorWrite: false, transparent: true, depthWrite: false });
  return { body: stencil(body, PALE), rim: stencil(rim, OUTLINE) };
}

function opacityOf(style: FigureStyle, accent: boolean): number {
  if (style.kind === "solid") return 1;
  if (style.kind === "accent") return accent ? style.opacity : 0.35 * style.opacity;
  return 0.2;
}

/** Solid bodies first, then futures by their marks. */
function orderOf(style: FigureStyle): number {
  if (style.kind === "solid") return 0;
  if (style.kind === "future") return 1 + style.index / 100;
  return style.kind === "accent" && style.opacity === 1 ? 1 : 2;
}

/** The material of a part; -1: of joints in no part. */
function materialFor(part: number, style: FigureStyle, colours: Theme): MeshStandardMaterial {
  const { ghost } = colours;
  const own = part < 0 ? ghost : partColourNow(part, colours);
  const look = { roughness: 0.62, metalness: 0 };
  const accent = style.kind === "accent" && style.part === part;
  const opacity = opacityOf(style, accent);
  const color = accent || style.kind === "solid" || style.kind === "future" ? own : ghost;
  const depthWrite = style.kind !== "future";
  const material = new MeshStandardMaterial({
    ...look,
    color,
    transparent: opacity < 1,
    opacity,
    depthWrite,
  });
  const pale = style.kind === "future" ? FIRST_FUTURE + style.index : PALE;
  stencil(material, opacity < 1 ? pale : SOLID);
  return material;
}

/** A capsule with a radius for each end, from the origin upwards. */
function taperedCapsule(length: number, r0: number, r1: number): LatheGeometry {
  const outline: Vector2[] = [];
  const rounds = 5;
  for (let i = 0; i <= rounds; i++) {
    const angle = (-0.5 + (0.5 * i) / rounds) * Math.PI;
    outline.push(new Vector2(Math.max(1e-5, r0 * Math.cos(angle)), r0 * Math.sin(angle)));
  }
  for (let i = 0; i <= rounds; i++) {
    const angle = ((0.5 * i) / rounds) * Math.PI;
    outline.push(new Vector2(Math.max(1e-5, r1 * Math.cos(angle)), length + r1 * Math.sin(angle)));
  }
  return new LatheGeometry(outline, 24);
}

export class FigureView {
  readonly group = new Group();
  #bones: { mesh: Mesh; capsule: Capsule }[] = [];
  #balls: { mesh: Mesh; ball: Ball }[] = [];
  /** The material of each part; -1: of joints in no part. An outline has two materials for the whole figure. */
  readonly #materials = new Map<number, Material>();
  readonly #a = new Vector3();
  readonly #b = new Vector3();
  readonly #side = new Vector3();
  readonly #front = new Vector3();
  readonly #basis = new Matrix4();

  constructor(
    figure: Figure,
    joints: readonly string[],
    parts: readonly PartSpec[],
    pose: Float32Array,
    style: FigureStyle,
    colours = theme(),
  ) {
    const shape = shapeOf(figure, joints, pose);
    if (style.kind === "ghost") {
      const { body, rim } = outline(colours);
      this.#materials.set(-1, body).set(-2, rim);
      this.#addBody(shape, style, 0, () => body);
      this.#addBody(shape, style, OUTLINE_WIDTH, () => rim);
      return;
    }
    const part = partOfJoints(joints.length, parts);
    const materialOf = (joint: number) => {
      const index = part[joint] ?? -1;
      const material = this.#materials.get(index) ?? materialFor(index, style, colours);
      this.#materials.set(index, material);
      return material;
    };
    this.#addBody(shape, style, 0, materialOf);
  }

  /** Adds the meshes of a body. `thicker`: metres added to each radius. */
  #addBody(shape: Shape, style: FigureStyle, thicker: number, materialOf: (joint: number) => Material): void {
    for (const capsule of shape.capsules) {
      const mesh = new Mesh(
        taperedCapsule(capsule.length, capsule.r0 + thicker, capsule.r1 + thicker),
        materialOf(capsule.joint),
      );
      if (capsule.across) mesh.scale.set(...TRUNK_WIDTH);
      this.#bones.push({ mesh, capsule });
      this.#add(mesh, style, thicker);
    }
    for (const ball of shape.balls) {
      const mesh = new Mesh(new SphereGeometry(ball.radius + thicker, 28, 20), materialOf(ball.joint));
      mesh.scale.set(0.88, 1.12, 0.98);
      this.#balls.push({ mesh, ball });
      this.#add(mesh, style, thicker);
    }
  }

  #add(mesh: Mesh, style: FigureStyle, thicker: number): void {
    mesh.castShadow = style.kind === "solid";
    mesh.receiveShadow = style.kind === "solid";
    mesh.frustumCulled = false;
    // A rim is drawn after the body that it surrounds.
    mesh.renderOrder = orderOf(style) + thicker;
    this.group.add(mesh);
  }

  /** Fades the whole figure or one part, 0 to 1. */
  fade(opacity: number, part?: number): void {
    const materials = part === undefined ? [...this.#materials.values()] : [this.#materials.get(part)];
    for (const material of materials) {
      if (!material) continue;
      material.transparent = opacity < 1;
      material.opacity = opacity;
      stencil(material, opacity < 1 ? PALE : SOLID);
      material.needsUpdate = true;
    }
    for (const { mesh } of [...this.#bones, ...this.#balls]) {
      if (!materials.includes(mesh.material as Material)) continue;
      mesh.castShadow = opacity > 0.5;
      mesh.renderOrder = opacity < 1 ? 3 : 0;
    }
  }

  /** Node positions [nodes x 3]. */
  pose(positions: Float32Array): void {
    for (const { mesh, capsule } of this.#bones) {
      this.#a.fromArray(positions, 3 * capsule.from);
      this.#b.fromArray(positions, 3 * capsule.to).sub(this.#a);
      const length = this.#b.length();
      mesh.position.copy(this.#a);
      if (length < 1e-6) continue;
      // Bones between recorded points do not keep their length exactly.
      mesh.scale.y = length / capsule.length;
      this.#b.divideScalar(length);
      if (capsule.across) this.#turnAcross(mesh, this.#b, positions, capsule.across);
      else mesh.quaternion.setFromUnitVectors(UP, this.#b);
    }
    for (const { mesh, ball } of this.#balls) {
      mesh.position.fromArray(positions, 3 * ball.node);
      if (ball.towards === null) continue;
      this.#b.fromArray(positions, 3 * ball.towards).sub(mesh.position);
      const length = this.#b.length();
      if (length > 1e-6) mesh.quaternion.setFromUnitVectors(UP, this.#b.clone().divideScalar(length));
      mesh.position.addScaledVector(this.#b, 0.5);
    }
  }

  /** Lays a capsule along a bone, its wide side from the body's left to its right. */
  #turnAcross(mesh: Mesh, along: Vector3, positions: Float32Array, [right, left]: [number, number]): void {
    this.#side.fromArray(positions, 3 * left).sub(this.#front.fromArray(positions, 3 * right));
    this.#side.addScaledVector(along, -this.#side.dot(along));
    if (this.#side.lengthSq() < 1e-8) {
      mesh.quaternion.setFromUnitVectors(UP, along);
      return;
    }
    this.#side.normalize();
    this.#front.crossVectors(this.#side, along);
    mesh.quaternion.setFromRotationMatrix(this.#basis.makeBasis(this.#side, along, this.#front));
  }

  dispose(): void {
    for (const { mesh } of [...this.#bones, ...this.#balls]) mesh.geometry.dispose();
    for (const material of this.#materials.values()) material.dispose();
    this.group.removeFromParent();
  }
}
