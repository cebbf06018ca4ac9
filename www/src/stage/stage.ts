// The stage: figure, ghost and ground, seen by a camera that follows the walk.
import { PCFShadowMap, PerspectiveCamera, Scene, SRGBColorSpace, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { HERE, placeOnto, poseAt } from "../scene/motion";
import { theme } from "../ui/palette";
import type { Motion } from "../engine/protocol";
import { type FigureStyle, FigureView } from "../scene/figure";
import { Ground } from "../scene/ground";
import { Lights } from "../scene/lights";
import { type Fineness, Pace } from "../scene/pace";
import { feetOf, floorOf, SOLE } from "../scene/standing";
import type { Playback } from "./playback";
import type { Marks, Shown, StageStore } from "./stage-store";

const LOOK_AT_HEIGHT = 0.88;
/** Pixels drawn for each of the page's, at most. */
const PIXELS: Record<Fineness, number> = { fine: 2, plain: 1, coarse: 0.5 };

export class Stage {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(30, 1, 0.1, 60);
  private readonly controls: OrbitControls;
  private readonly ground = new Ground();
  private readonly lights = new Lights(this.scene, 1024);
  private figure: FigureView | null = null;
  private ghost: FigureView | null = null;
  private marked: FigureView[] = [];
  /** What the figure, and the marked poses, were made for. */
  private figureOf: Shown | null = null;
  private markedOf: Marks | null = null;
  private feet: number[] = [];
  private floor = 0;
  private readonly focus = new Vector3(0, LOOK_AT_HEIGHT, 0);
  /** Where the figure was when last drawn. */
  private readonly root = new Vector3();
  private placed = false;
  private dirty = true;
  private drawn = 0;
  private readonly pace = new Pace();
  private fineness: Fineness = "fine";
  private ghostPose = new Float32Array(0);

  /** Throws where the browser has no WebGL. */
  constructor(
    private readonly store: StageStore,
    private readonly playback: Playback,
    readonly canvas: HTMLCanvasElement,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, stencil: true, powerPreference: "low-power" });
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.scene.add(this.ground.group);
    this.controls = new OrbitControls(this.camera, canvas);
    Object.assign(this.controls, {
      enablePan: false,
      enableDamping: true,
      dampingFactor: 0.12,
      minDistance: 1.6,
      maxDistance: 12,
      minPolarAngle: 0.15,
      maxPolarAngle: Math.PI / 2 - 0.03,
      rotateSpeed: 0.8,
      zoomSpeed: 0.7,
    });
    this.controls.target.copy(this.focus);
    this.controls.addEventListener("change", () => (this.dirty = true));
    this.resize();
    this.recolour();
  }

  /** Gives the graphics memory back. */
  dispose(): void {
    this.clear();
    this.lights.dispose();
    this.ground.dispose();
    this.controls.dispose();
    this.renderer.dispose();
  }

  /** Takes the colours of the page over. */
  recolour(): void {
    this.renderer.setClearColor(theme().ground);
    this.lights.recolour();
    this.ground.recolour();
    this.clear();
    this.update();
  }

  /** Another frame is to be drawn. */
  tick(): void {
    this.dirty = true;
  }

  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement ?? this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(PIXELS[this.fineness], devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.dirty = true;
  }

  private make(shown: Shown, style: FigureStyle): FigureView {
    const pose = poseAt(shown.motion, 0, HERE, new Float32Array(shown.motion.nodes * 3));
    const view = new FigureView(shown.figure, shown.joints, shown.parts, pose, style);
    this.scene.add(view.group);
    return view;
  }

  /** Takes away all figures. */
  private clear(): void {
    for (const figure of [this.figure, this.ghost, ...this.marked]) figure?.dispose();
    [this.figure, this.ghost, this.marked] = [null, null, []];
    [this.figureOf, this.markedOf] = [null, null];
  }

  /** Makes the figures of what is shown now. */
  update(): void {
    this.dirty = true;
    const { shown } = this.store;
    if (!shown) return;
    this.updateFigure(shown);
    this.updateGhost(shown);
    this.updateMarked(shown);
  }

  private updateFigure(shown: Shown): void {
    const before = this.figureOf;
    if (before === shown) return;
    this.figureOf = shown;
    if (!before || !sameBody(before, shown)) {
      this.clear();
      this.figureOf = shown;
      this.figure = this.make(shown, { kind: "solid" });
      this.floor = floorOf(shown.motion) - SOLE;
      this.feet = feetOf(shown.motion, this.floor + SOLE);
      this.ground.group.position.y = this.floor;
    }
    if (!this.placed || (before && before.motion.nodes !== shown.motion.nodes)) this.placeCamera(shown);
  }

  private updateGhost(shown: Shown): void {
    if (shown.kind === "model" && this.store.ghost) {
      this.ghost ??= this.make(shown, { kind: "ghost" });
    } else {
      this.ghost?.dispose();
      this.ghost = null;
    }
  }

  /** The poses that an inducing point stands for. */
  private updateMarked(shown: Shown): void {
    const marks = shown.kind === "model" ? this.store.marks : null;
    if (this.markedOf === marks) return;
    this.markedOf = marks;
    for (const figure of this.marked) figure.dispose();
    this.marked = (marks?.poses ?? []).map(({ part, opacity }) => this.make(shown, { kind: "accent", part, opacity }));
    this.figure?.fade(this.marked.length > 0 ? 0.12 : 1);
  }

  /** Looks at the walk from the side and a little from the front. */
  private placeCamera({ motion }: Shown): void {
    const { pose } = this.playback;
    if (!pose) return;
    const [before, after] = [new Vector3(), new Vector3()];
    before.fromArray(motion.positions);
    after.fromArray(motion.positions, Math.min(motion.frames - 1, 60) * motion.nodes * 3);
    const [dx, dz] = [after.x - before.x, after.z - before.z];
    const heading = Math.hypot(dx, dz) > 0.2 ? Math.atan2(dx, dz) : 0;
    this.focus.fromArray(pose).setY(this.floor + LOOK_AT_HEIGHT);
    this.root.copy(this.focus);
    const away = this.camera.aspect < 0.9 ? 5.6 : 4.7;
    const angle = heading + 0.95;
    this.controls.target.copy(this.focus);
    this.camera.position.set(
      this.focus.x + away * Math.sin(angle),
      this.focus.y + 0.5,
      this.focus.z + away * Math.cos(angle),
    );
    this.controls.update();
    this.placed = true;
  }

  turnByKey(event: KeyboardEvent): void {
    const turn = {
      a: { sideways: -0.12, upwards: 0 },
      d: { sideways: 0.12, upwards: 0 },
      w: { sideways: 0, upwards: -0.08 },
      s: { sideways: 0, upwards: 0.08 },
    }[event.key];
    const zoom = { "+": 0.9, "-": 1.1 }[event.key];
    if (!turn && !zoom) return;
    const offset = this.camera.position.clone().sub(this.controls.target);
    if (zoom) offset.multiplyScalar(zoom);
    if (turn) {
      offset.applyAxisAngle(new Vector3(0, 1, 0), turn.sideways);
      const side = new Vector3(0, 1, 0).cross(offset).normalize();
      offset.applyAxisAngle(side, turn.upwards);
    }
    this.camera.position.copy(this.controls.target).add(offset);
    this.dirty = true;
    event.preventDefault();
  }

  /** Draws when something changed. `seconds` since the last call. */
  draw(seconds: number): void {
    this.controls.update();
    this.setFineness(this.pace.next(seconds, this.dirty, this.playback.playing));
    if (!this.dirty) return;
    const { pose } = this.playback;
    if (pose && this.figure) this.poseAll(pose, seconds);
    this.renderer.render(this.scene, this.camera);
    this.drawn += 1;
    if (this.figure) this.canvas.dataset.framesDrawn = String(this.drawn);
    this.pace.drawn();
    this.dirty = false;
  }

  private poseAll(pose: Float32Array, seconds: number): void {
    this.figure?.pose(pose);
    this.poseGhost(pose);
    this.marked.forEach((figure, i) => {
      const marked = this.markedOf?.poses[i];
      if (marked) figure.pose(placed(marked.positions, pose));
    });
    this.followWalk(pose, seconds);
    this.ground.touch(pose, this.marked.length > 0 ? [] : this.feet, this.floor);
  }

  /** On a machine that falls behind: fewer pixels, and the shadow drawn anew every third frame only. */
  private setFineness(fineness: Fineness): void {
    if (fineness !== this.fineness) {
      this.fineness = fineness;
      this.resize();
    }
    const { shadowMap } = this.renderer;
    shadowMap.autoUpdate = fineness === "fine";
    shadowMap.needsUpdate = fineness === "plain" && this.drawn % 3 === 0;
  }

  private poseGhost(pose: Float32Array): void {
    const motion = this.store.ghost;
    if (!this.ghost || !motion || motion.nodes * 3 !== pose.length) return;
    if (this.ghostPose.length !== pose.length) this.ghostPose = new Float32Array(pose.length);
    const { frame } = this.playback;
    poseAt(motion, frame, HERE, this.ghostPose);
    this.ghost.pose(poseAt(motion, frame, placeOnto(this.ghostPose, pose), this.ghostPose));
  }

  /** Moves camera and light along with the figure: softly while it plays, by just as much as it moves while it is stepped or scrubbed. */
  private followWalk(pose: Float32Array, seconds: number): void {
    const { x, z } = new Vector3().fromArray(pose);
    let [dx, dz] = [x - this.focus.x, z - this.focus.z];
    if (Math.hypot(dx, dz) < 3) {
      const part = 1 - Math.exp(-9 * Math.min(seconds, 0.1));
      [dx, dz] = this.playback.playing ? [part * dx, part * dz] : [x - this.root.x, z - this.root.z];
    }
    this.root.set(x, 0, z);
    this.focus.x += dx;
    this.focus.z += dz;
    this.camera.position.x += dx;
    this.camera.position.z += dz;
    this.controls.target.copy(this.focus);
    this.ground.follow(x, z);
    this.lights.follow(x, this.floor, z);
  }
}

/** Puts a marked pose where the figure stands, turned as it is. */
function placed(marked: Float32Array, pose: Float32Array): Float32Array {
  const motion: Motion = { positions: marked, frames: 1, nodes: marked.length / 3, frameTime: 1 };
  return poseAt(motion, 0, placeOnto(marked, pose), new Float32Array(marked.length));
}

/** Whether a figure made for one can show the other. */
function sameBody(a: Shown, b: Shown): boolean {
  return JSON.stringify([a.figure, a.joints, a.parts]) === JSON.stringify([b.figure, b.joints, b.parts]);
}
