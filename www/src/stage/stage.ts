// The stage: figure, ghost and ground, seen by a camera that follows the walk.
import { PCFShadowMap, PerspectiveCamera, Scene, SRGBColorSpace, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { App, Shown } from "../app/app";
import { HERE, placeOnto, poseAt } from "../scene/motion";
import { onThemeChange, theme } from "../ui/palette";
import type { Motion } from "../engine/protocol";
import { type FigureStyle, FigureView } from "../scene/figure";
import { Ground } from "../scene/ground";
import { Lights } from "../scene/lights";
import { type Fineness, Pace } from "../scene/pace";
import { feetOf, floorOf, SOLE } from "../scene/standing";

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
  private figureOf: Shown | null = null;
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
    private readonly app: App,
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
    canvas.addEventListener("keydown", (event) => this.turnByKey(event));
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement ?? canvas);
    onThemeChange(() => this.recolour());
    app.on(["shown"], () => this.rebuild());
    app.on(["rollout", "model"], () => this.rebuildGhost());
    app.on(["pointed"], () => this.rebuildMarked());
    app.on(["tick"], () => (this.dirty = true));
    this.resize();
    this.recolour();
  }

  private recolour(): void {
    this.renderer.setClearColor(theme().ground);
    this.lights.recolour();
    this.ground.recolour();
    this.figureOf = null;
    this.rebuild();
  }

  private resize(): void {
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

  private rebuild(): void {
    const { shown } = this.app;
    this.dirty = true;
    if (!shown) return;
    const before = this.figureOf;
    const same =
      before !== null &&
      JSON.stringify([before.figure, before.joints, before.parts]) ===
        JSON.stringify([shown.figure, shown.joints, shown.parts]);
    this.figureOf = shown;
    if (!same) {
      this.figure?.dispose();
      this.figure = this.make(shown, { kind: "solid" });
      this.floor = floorOf(shown.motion) - SOLE;
      this.feet = feetOf(shown.motion, this.floor + SOLE);
      this.ground.group.position.y = this.floor;
      this.ghost?.dispose();
      this.ghost = null;
    }
    this.rebuildGhost();
    this.rebuildMarked();
    if (!this.placed || (before && before.motion.nodes !== shown.motion.nodes)) this.placeCamera();
  }

  private rebuildGhost(): void {
    const { app } = this;
    const wanted = app.shown?.kind === "model" && app.altered && app.learned !== null;
    this.dirty = true;
    if (!wanted) {
      this.ghost?.dispose();
      this.ghost = null;
    } else if (!this.ghost && app.shown) {
      this.ghost = this.make(app.shown, { kind: "ghost" });
    }
  }

  /** The pose of the inducing point that is pointed at; for a dynamics point also the pose it predicts. */
  private rebuildMarked(): void {
    const { pointed, shown } = this.app;
    this.marked.forEach((figure) => figure.dispose());
    this.marked = [];
    this.dirty = true;
    if (pointed && shown?.kind === "model") {
      const { point } = pointed;
      const parts = point.kind === "pose" ? [point.part] : [point.source, point.target];
      this.marked = pointed.poses.map((_, i) =>
        this.make(shown, {
          kind: "accent",
          part: parts[i] ?? 0,
          opacity: point.kind === "dynamics" && i === 0 ? 0.5 : 1,
        }),
      );
    }
    this.figure?.fade(this.marked.length > 0 ? 0.12 : 1);
  }

  /** Looks at the walk from the side and a little from the front. */
  private placeCamera(): void {
    const { shown, walk, player } = this.app;
    if (!shown || !walk) return;
    const { positions, frames, nodes } = shown.motion;
    const end = Math.min(frames - 1, 60) * nodes * 3;
    const [dx, dz] = [positions[end]! - positions[0]!, positions[end + 2]! - positions[2]!];
    const heading = Math.hypot(dx, dz) > 0.2 ? Math.atan2(dx, dz) : 0;
    const pose = walk.at(player.frame);
    this.focus.set(pose[0]!, this.floor + LOOK_AT_HEIGHT, pose[2]!);
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

  private turnByKey(event: KeyboardEvent): void {
    const turn = { a: [-0.12, 0], d: [0.12, 0], w: [0, -0.08], s: [0, 0.08] }[event.key];
    const zoom = { "+": 0.9, "-": 1.1 }[event.key];
    if (!turn && !zoom) return;
    const offset = this.camera.position.clone().sub(this.controls.target);
    if (zoom) offset.multiplyScalar(zoom);
    if (turn) {
      offset.applyAxisAngle(new Vector3(0, 1, 0), turn[0]!);
      const side = new Vector3(0, 1, 0).cross(offset).normalize();
      offset.applyAxisAngle(side, turn[1]!);
    }
    this.camera.position.copy(this.controls.target).add(offset);
    this.dirty = true;
    event.preventDefault();
  }

  /** Draws when something changed. `seconds` since the last call. */
  draw(seconds: number): void {
    this.controls.update();
    const { app } = this;
    this.setFineness(this.pace.next(seconds, this.dirty, app.player.playing));
    if (!this.dirty) return;
    if (app.walk && this.figure) this.poseAll(app.walk.at(app.player.frame), seconds);
    this.renderer.render(this.scene, this.camera);
    if (this.figure) this.canvas.dataset["framesDrawn"] = String(++this.drawn);
    this.pace.drawn();
    this.dirty = false;
  }

  private poseAll(pose: Float32Array, seconds: number): void {
    this.figure?.pose(pose);
    this.poseGhost(pose);
    this.app.pointed?.poses.forEach((marked, i) => this.marked[i]?.pose(placed(marked, pose)));
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
    const motion: Motion | undefined = this.app.learned?.motion;
    if (!this.ghost || !motion || motion.nodes * 3 !== pose.length) return;
    if (this.ghostPose.length !== pose.length) this.ghostPose = new Float32Array(pose.length);
    const frame = this.app.player.frame;
    poseAt(motion, frame, HERE, this.ghostPose);
    this.ghost.pose(poseAt(motion, frame, placeOnto(this.ghostPose, pose), this.ghostPose));
  }

  /** Moves camera and light along with the figure: softly while it plays, by just as much as it moves while it is stepped or scrubbed. */
  private followWalk(pose: Float32Array, seconds: number): void {
    const [x, z] = [pose[0]!, pose[2]!];
    let [dx, dz] = [x - this.focus.x, z - this.focus.z];
    if (Math.hypot(dx, dz) < 3) {
      const part = 1 - Math.exp(-9 * Math.min(seconds, 0.1));
      [dx, dz] = this.app.player.playing ? [part * dx, part * dz] : [x - this.root.x, z - this.root.z];
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
