// Several figures in one picture, side by side under one clock and one camera, each with the real trial as its ghost.
import { PCFShadowMap, PerspectiveCamera, Scene, SRGBColorSpace, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { HERE, placeOnto, poseAt } from "../scene/motion";
import { onThemeChange, theme } from "../ui/palette";
import type { Figure, Motion, PartSpec } from "../engine/protocol";
import { FigureView } from "../scene/figure";
import { Ground } from "../scene/ground";
import { Lights } from "../scene/lights";
import { type Fineness, Pace } from "../scene/pace";
import { feetOf, floorOf, SOLE } from "../scene/standing";

export interface Body {
  figure: Figure;
  joints: string[];
  parts: PartSpec[];
}

/** What one column shows. */
export interface ColumnMotion {
  predicted: Motion;
  actual: Motion;
}

const LOOK_AT_HEIGHT = 0.88;
/** Of the figure's height that is about in the middle, as far to each side as a stride and swinging arms need. */
const HALF_WIDTH = 0.85;
const HALF_HEIGHT = 1.12;
/** Pixels drawn for each of the page's, at most. */
const PIXELS: Record<Fineness, number> = { fine: 2, plain: 1, coarse: 0.5 };

/** One column: a figure, its ghost and the ground under it. */
class Column {
  readonly scene = new Scene();
  private readonly ground = new Ground();
  private readonly lights = new Lights(this.scene, 512);
  private readonly figure: FigureView;
  private readonly ghost: FigureView;
  private readonly floor: number;
  private readonly feet: number[];
  private readonly pose: Float32Array;
  private readonly ghostPose: Float32Array;

  constructor(
    body: Body,
    readonly motion: ColumnMotion,
  ) {
    const { predicted, actual } = motion;
    this.pose = poseAt(predicted, 0, HERE, new Float32Array(predicted.nodes * 3));
    this.ghostPose = this.pose.slice();
    const make = (kind: "solid" | "ghost") => new FigureView(body.figure, body.joints, body.parts, this.pose, { kind });
    [this.figure, this.ghost] = [make("solid"), make("ghost")];
    this.floor = floorOf(actual) - SOLE;
    this.feet = feetOf(actual, this.floor + SOLE);
    this.ground.group.position.y = this.floor;
    this.scene.add(this.ground.group, this.ghost.group, this.figure.group);
  }

  /** Poses figure and ghost; answers where to look. */
  at(frame: number, out: Vector3): Vector3 {
    const { predicted, actual } = this.motion;
    poseAt(predicted, frame, HERE, this.pose);
    poseAt(actual, frame, HERE, this.ghostPose);
    poseAt(actual, frame, placeOnto(this.ghostPose, this.pose), this.ghostPose);
    this.figure.pose(this.pose);
    this.ghost.pose(this.ghostPose);
    const [x, z] = [this.pose[0]!, this.pose[2]!];
    this.ground.follow(x, z);
    this.ground.touch(this.pose, this.feet, this.floor);
    this.lights.follow(x, this.floor, z);
    return out.set(x, this.floor + LOOK_AT_HEIGHT, z);
  }

  /** The direction in which the trial walks, seen from above. */
  get heading(): number {
    const { positions, frames, nodes } = this.motion.actual;
    const end = Math.min(frames - 1, 60) * nodes * 3;
    const [dx, dz] = [positions[end]! - positions[0]!, positions[end + 2]! - positions[2]!];
    return Math.hypot(dx, dz) > 0.2 ? Math.atan2(dx, dz) : 0;
  }

  dispose(): void {
    this.figure.dispose();
    this.ghost.dispose();
    this.lights.dispose();
    this.ground.dispose();
  }
}

export class Columns {
  private readonly renderer: WebGLRenderer;
  private readonly camera = new PerspectiveCamera(30, 1, 0.1, 60);
  private readonly controls: OrbitControls;
  private columns: Column[] = [];
  private body: Body | null = null;
  private dirty = true;
  private drawn = 0;
  private readonly pace = new Pace();
  private fineness: Fineness = "fine";
  /** From the point that is looked at to the camera, the same in all columns. */
  private readonly offset = new Vector3();
  private readonly focus = new Vector3();
  private readonly observer = new ResizeObserver(() => this.resize());
  private readonly stopThemes: () => void;

  /** Throws where the browser has no WebGL. */
  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, stencil: true, powerPreference: "low-power" });
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.autoClear = false;
    this.controls = new OrbitControls(this.camera, canvas);
    Object.assign(this.controls, {
      enablePan: false,
      enableZoom: false,
      minPolarAngle: 0.15,
      maxPolarAngle: Math.PI / 2 - 0.03,
      rotateSpeed: 0.8,
    });
    this.controls.target.set(0, 0, 0);
    this.controls.addEventListener("change", () => (this.dirty = true));
    this.observer.observe(canvas.parentElement ?? canvas);
    this.stopThemes = onThemeChange(() =>
      this.show(
        this.body,
        this.columns.map(({ motion }) => motion),
      ),
    );
  }

  /** Takes these motions up, from left to right; all have the same body. */
  show(body: Body | null, motions: readonly ColumnMotion[]): void {
    const first = this.columns.length === 0;
    this.columns.forEach((column) => column.dispose());
    this.body = body;
    this.columns = body ? motions.map((motion) => new Column(body, motion)) : [];
    this.renderer.setClearColor(theme().ground);
    if (first && this.columns[0]) {
      const angle = this.columns[0].heading + 1.15;
      this.camera.position.set(Math.sin(angle), 0.1, Math.cos(angle));
    }
    this.resize();
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement ?? this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(PIXELS[this.fineness], devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(1, this.columns.length) / height;
    this.camera.updateProjectionMatrix();
    // As near as the whole figure fits into its column.
    const tangent = Math.tan((this.camera.fov * Math.PI) / 360);
    const away = Math.max(HALF_HEIGHT, HALF_WIDTH / this.camera.aspect) / tangent;
    this.camera.position.setLength(away);
    this.controls.minDistance = this.controls.maxDistance = away;
    this.dirty = true;
  }

  turnByKey(event: KeyboardEvent): void {
    const turn = { a: [-0.12, 0], d: [0.12, 0], w: [0, -0.08], s: [0, 0.08] }[event.key];
    if (!turn) return;
    const { position } = this.camera;
    position.applyAxisAngle(new Vector3(0, 1, 0), turn[0]!);
    position.applyAxisAngle(new Vector3(0, 1, 0).cross(position).normalize(), turn[1]!);
    this.dirty = true;
    event.preventDefault();
  }

  /** Draws all columns at a frame when something changed. `seconds` since the last call. */
  draw(frame: number, changed: boolean, seconds: number, playing: boolean): void {
    this.controls.update();
    this.dirty ||= changed;
    const fineness = this.pace.next(seconds, this.dirty, playing);
    if (fineness !== this.fineness) {
      this.fineness = fineness;
      this.resize();
    }
    if (!this.dirty) return;
    this.dirty = false;
    const { renderer, camera, canvas } = this;
    const [width, height] = [canvas.parentElement!.clientWidth, canvas.parentElement!.clientHeight];
    this.offset.copy(camera.position);
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    this.columns.forEach((column, i) => {
      const left = Math.round((i * width) / this.columns.length);
      const right = Math.round(((i + 1) * width) / this.columns.length);
      renderer.setViewport(left, 0, right - left, height);
      renderer.setScissor(left, 0, right - left, height);
      column.at(frame, this.focus);
      camera.position.copy(this.offset).add(this.focus);
      camera.updateMatrixWorld();
      renderer.render(column.scene, camera);
    });
    camera.position.copy(this.offset);
    camera.updateMatrixWorld();
    this.pace.drawn();
    canvas.dataset["framesDrawn"] = String(++this.drawn);
  }

  dispose(): void {
    this.stopThemes();
    this.observer.disconnect();
    this.controls.dispose();
    this.columns.forEach((column) => column.dispose());
    this.renderer.dispose();
  }
}
