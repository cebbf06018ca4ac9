// Several figures side by side in one picture, with one clock, one camera, and optional ghosts.
import { Scene, Vector3, Color, Group, Mesh, MeshStandardMaterial, SphereGeometry } from "three";
import type { Figure, Motion, PartSpec } from "../engine/protocol";
import { FigureView } from "./figure";
import { Framing } from "./framing";
import { Ground } from "./ground";
import { Lights } from "./lights";
import { HERE, placeOnto, poseAt } from "./motion";
import { feetOf, floorOf, MIDDLE, SOLE, type View, viewOf } from "./stance";
import { Viewport } from "./viewport";
import { theme } from "../ui/palette";

/** Metres. */
const RADIUS = 0.026;

class PointLights {
  readonly group = new Group();
  readonly #lights: Mesh[];
  readonly #geometry = new SphereGeometry(RADIUS, 16, 12);
  /** The material ignores the lights of the scene. */
  readonly #material = new MeshStandardMaterial({ color: 0x000000, emissive: new Color(theme().ink) });

  /** A light at each of these nodes. */
  constructor(private readonly nodes: readonly number[]) {
    this.#lights = nodes.map(() => new Mesh(this.#geometry, this.#material));
    for (const light of this.#lights) light.frustumCulled = false;
    this.group.add(...this.#lights);
  }

  /** Node positions [nodes x 3]. */
  pose(positions: Float32Array): void {
    this.#lights.forEach((light, i) => light.position.fromArray(positions, 3 * this.nodes[i]!));
  }

  dispose(): void {
    this.#geometry.dispose();
    this.#material.dispose();
    this.group.removeFromParent();
  }
}

export interface Body {
  figure: Figure;
  joints: string[];
  parts: PartSpec[];
  /** Nodes with a light, for a body of points only, without ground and ghost. Absent: a figure. */
  lights?: number[];
}

/** The content of one column. */
export interface ColumnMotion {
  motion: Motion;
  /** Placed on the figure; defines the height of the ground. */
  ghost: Motion | null;
  /**
   * Speed of the camera along the ground, metres a second, from the origin. Absent: it follows the figure.
   */
  camera?: { x: number; z: number };
}

/** Half height and half width of the visible space around a figure, at least: with swinging arms; metres. */
const HALF_HEIGHT = 1.12;
const HALF_WIDTH = 0.85;
/** The angle between heading and camera, radians. */
const SIDE = 1.15;
/** Pixels of a column's shadow, each way. */
const SHADOW = 512;

/** One column: a figure, its ghost and the ground under it. */
class Column {
  readonly scene = new Scene();
  readonly #ground = new Ground();
  readonly #lights = new Lights(this.scene, SHADOW);
  readonly #figure: FigureView | PointLights;
  readonly #ghost: FigureView | null;
  #current: ColumnMotion;
  #floor = 0;
  #feet: number[] = [];
  readonly #pose: Float32Array;
  readonly #ghostPose: Float32Array;

  constructor({ figure, joints, parts, lights }: Body, current: ColumnMotion) {
    const { motion, ghost } = current;
    this.#pose = poseAt(motion, 0, HERE, new Float32Array(motion.nodes * 3));
    this.#ghostPose = this.#pose.slice();
    if (lights) {
      this.#figure = new PointLights(lights);
      this.#ghost = null;
    } else {
      this.#figure = new FigureView(figure, joints, parts, this.#pose, { kind: "solid" });
      this.#ghost = ghost && new FigureView(figure, joints, parts, this.#pose, { kind: "ghost" });
      this.scene.add(this.#ground.group);
    }
    this.scene.add(this.#figure.group);
    if (this.#ghost) this.scene.add(this.#ghost.group);
    this.#current = current;
    this.take(current);
  }

  get current(): ColumnMotion {
    return this.#current;
  }

  /** Shows another motion of the same body. A ghost needs a ghost before. */
  take(current: ColumnMotion): void {
    this.#current = current;
    const ground = current.ghost ?? current.motion;
    this.#floor = floorOf(ground) - SOLE;
    this.#feet = feetOf(ground, this.#floor + SOLE);
    this.#ground.group.position.y = this.#floor;
  }

  /** The view of all motions of this column. */
  view(slope: number, aspect: number): View {
    const { motion, ghost } = this.#current;
    const motions = ghost ? [motion, ghost] : [motion];
    return widest(motions.map((motion) => viewOf(motion, this.#floor, { slope, aspect })));
  }

  /** The last pose. */
  get pose(): Float32Array {
    return this.#pose;
  }

  /** Poses figure and ghost, and writes the place on the ground below the picture's centre into `place`. */
  at(frame: number, place: Vector3): void {
    const { motion, ghost } = this.#current;
    const pose = poseAt(motion, frame, HERE, this.#pose);
    this.#figure.pose(pose);
    if (ghost) {
      poseAt(ghost, frame, HERE, this.#ghostPose);
      this.#ghost?.pose(poseAt(ghost, frame, placeOnto(this.#ghostPose, pose), this.#ghostPose));
    }
    const [x, z] = this.#place(frame, pose);
    this.#ground.follow(x, z);
    this.#ground.touch(pose, this.#feet, this.#floor);
    this.#lights.follow(x, this.#floor, z);
    place.set(x, this.#floor, z);
  }

  /** The place on the ground below the centre of the picture. */
  #place(frame: number, pose: Float32Array): [x: number, z: number] {
    const { camera, motion } = this.#current;
    if (!camera) return [pose[0] ?? 0, pose[2] ?? 0];
    const seconds = frame * motion.frameTime;
    return [camera.x * seconds, camera.z * seconds];
  }

  dispose(): void {
    this.#figure.dispose();
    this.#ghost?.dispose();
    this.#lights.dispose();
    this.#ground.dispose();
  }
}

/** The view that shows the content of all views. */
function widest(views: readonly View[]): View {
  const most = (key: keyof View) => Math.max(...views.map((view) => view[key]));
  return { middle: most("middle"), distance: most("distance") };
}

/** The camera of the columns. */
export interface ColumnsView {
  /**
   * Direction from the figures to the camera, radians from their z axis, at a fixed distance; null: from the
   * side of the walk, as near as the whole motion is visible.
   */
  from: number | null;
  /** Whether the visitor can turn the camera. */
  turns: boolean;
}

export class Columns {
  readonly #viewport: Viewport;
  #columns: Column[] = [];
  #body: Body | null = null;
  /** Vector from the centre of the picture to the camera, the same in all columns. */
  readonly #offset = new Vector3();
  readonly #middle = new Vector3();
  readonly #from: number | null;
  readonly #framing: Framing;

  /** Throws where the browser has no WebGL. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    { from, turns }: ColumnsView = { from: null, turns: true },
  ) {
    this.#from = from;
    this.#viewport = new Viewport(canvas, {
      resized: (width, height) => this.#fit(width, height),
      recoloured: () => this.#remake(this.#columns.map(({ current }) => current)),
    });
    this.#viewport.renderer.autoClear = false;
    this.#viewport.controls.enableZoom = false;
    this.#viewport.controls.enabled = turns;
    this.#framing = new Framing(this.#viewport.camera.position);
  }

  /** Shows these motions of one body, from left to right. */
  show(body: Body, motions: readonly ColumnMotion[]): void {
    const [first] = motions;
    const isFirst = this.#columns.length === 0;
    const isOther = isFirst || first?.motion.nodes !== this.#columns[0]?.current.motion.nodes;
    if (this.#from === null && first && isOther) this.#framing.start(first.ghost ?? first.motion);
    if (isFirst) this.#framing.aim(this.#from ?? SIDE);
    const fit = (column: Column, i: number) => !column.current.ghost === !motions[i]?.ghost;
    if (body === this.#body && motions.length === this.#columns.length && this.#columns.every(fit)) {
      motions.forEach((motion, i) => this.#columns[i]?.take(motion));
      this.#viewport.resize();
      return;
    }
    this.#body = body;
    this.#remake(motions);
    this.#viewport.resize();
  }

  #remake(motions: readonly ColumnMotion[]): void {
    const body = this.#body;
    for (const column of this.#columns) column.dispose();
    this.#columns = body ? motions.map((motion) => new Column(body, motion)) : [];
  }

  /** Moves the camera as near as the whole motion still fits into its column. */
  #fit(width: number, height: number): void {
    const { camera } = this.#viewport;
    camera.aspect = width / Math.max(1, this.#columns.length) / height;
    this.#framing.wanted = this.#view();
    this.#framing.approach();
  }

  #view(): View {
    const { fov, aspect } = this.#viewport.camera;
    const slope = Math.tan((fov * Math.PI) / 360);
    const least = { middle: MIDDLE, distance: Math.max(HALF_HEIGHT, HALF_WIDTH / aspect) / slope };
    if (this.#from !== null) return least;
    return widest([least, ...this.#columns.map((column) => column.view(slope, aspect))]);
  }

  /**
   * Draws all columns at a frame, if they have changed. `seconds` since the last call. Calls `drawn` for
   * each.
   */
  draw(
    frame: number,
    changed: boolean,
    seconds: number,
    playing: boolean,
    drawn = (_column: number) => {},
  ): void {
    const viewport = this.#viewport;
    if (changed) viewport.changed();
    if (viewport.next(seconds, playing) === null) return;
    const { renderer, camera } = viewport;
    const { width, height } = viewport.size;
    this.#offset.copy(camera.position);
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    this.#columns.forEach((column, i) => {
      const left = Math.round((i * width) / this.#columns.length);
      const right = Math.round(((i + 1) * width) / this.#columns.length);
      renderer.setViewport(left, 0, right - left, height);
      renderer.setScissor(left, 0, right - left, height);
      column.at(frame, this.#middle);
      this.#middle.y += this.#framing.middle;
      camera.position.copy(this.#offset).add(this.#middle);
      camera.updateMatrixWorld();
      renderer.render(column.scene, camera);
      drawn(i);
    });
    camera.position.copy(this.#offset);
    camera.updateMatrixWorld();
    viewport.finish();
  }

  dispose(): void {
    for (const column of this.#columns) column.dispose();
    this.#viewport.dispose();
  }
}
