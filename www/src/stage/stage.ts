// The stage: figure, ghost, futures and ground, with a camera that follows the walk.
import { Scene, Vector3 } from "three";
import type { Motion } from "../engine/protocol";
import { type FigureStyle, FigureView } from "../scene/figure";
import { Framing } from "../scene/framing";
import { Ground } from "../scene/ground";
import { Lights } from "../scene/lights";
import { HERE, placeOnto, poseAt } from "../scene/motion";
import type { Quality } from "../scene/picture-quality";
import { feetOf, floorOf, MIDDLE, SOLE, type View, viewOf } from "../scene/stance";
import { Viewport } from "../scene/viewport";
import type { Playback } from "./playback";
import type { Marks, StageContent, StageStore } from "./stage-store";

/** Least distance of the camera from the figure, in a wide and in a high picture, metres. */
const NEAR = 4.7;
const NEAR_HIGH = 5.6;
/** In a picture of less height the figure is lower by a share of the height, because texts are above it. */
const LOW_PICTURE = 400;
const LOWER = 0.06;
/** The angle between the mean heading and the camera at first, radians: from the side, a little in front. */
const SIDE = 1.15;
/** Seconds between two looks at the reach of a live motion. */
const BETWEEN = 0.5;

/** Pixels of the figure's shadow, each way. */
const SHADOW = 1024;

export class Stage {
  readonly #store: StageStore;
  readonly #playback: Playback;
  readonly #viewport: Viewport;
  readonly #scene = new Scene();
  readonly #ground = new Ground();
  readonly #lights = new Lights(this.#scene, SHADOW);
  #figure: FigureView | null = null;
  #ghost: FigureView | null = null;
  #marked: FigureView[] = [];
  #futures: FigureView[] = [];
  /** The content that the figure and the marked poses were made for. */
  #figureOf: StageContent | null = null;
  #markedOf: Marks | null = null;
  #faded: { opacity: number; part?: number } | null = null;
  #feet: number[] = [];
  #floor = 0;
  readonly #focus = new Vector3(0, MIDDLE, 0);
  readonly #framing = new Framing(new Vector3());
  /** Seconds since the last look at the reach of a live motion. */
  #sinceLook = 0;
  /** The place of the figure in the last picture. */
  readonly #root = new Vector3();
  #placed = false;
  /** The pose of a ghost or a future. */
  #otherPose = new Float32Array(0);

  /** Throws where the browser has no WebGL. */
  constructor(store: StageStore, playback: Playback, canvas: HTMLCanvasElement) {
    this.#store = store;
    this.#playback = playback;
    this.#viewport = new Viewport(canvas, {
      resized: (width, height) => {
        const { camera } = this.#viewport;
        camera.aspect = width / height;
        camera.setViewOffset(width, height, 0, -this.#lower * height, width, height);
        const { content } = this.#store;
        if (content && this.#placed) this.#frame(content);
      },
      recoloured: () => this.#recolour(),
    });
    const { controls } = this.#viewport;
    const glide = { enableDamping: true, dampingFactor: 0.12 };
    Object.assign(controls, { ...glide, minDistance: 1.6, maxDistance: 12, zoomSpeed: 0.7 });
    controls.target.copy(this.#focus);
    this.#scene.add(this.#ground.group);
    this.#viewport.resize();
    store.camera = this.#camera;
    this.update();
  }

  /** From where the camera looks; null before the first figure. */
  readonly #camera = () => {
    const { camera, controls } = this.#viewport;
    this.#framing.offset.subVectors(camera.position, controls.target);
    return this.#placed ? this.#framing.look : null;
  };

  /** Frees the graphics memory. */
  dispose(): void {
    if (this.#store.camera === this.#camera) this.#store.camera = () => null;
    this.#clear();
    this.#lights.dispose();
    this.#ground.dispose();
    this.#viewport.dispose();
  }

  /** Uses the colours of the page. */
  #recolour(): void {
    this.#lights.recolour();
    this.#ground.recolour();
    this.#clear();
    this.update();
  }

  /** Asks for another picture. */
  tick(): void {
    this.#viewport.changed();
  }

  #make(content: StageContent, style: FigureStyle): FigureView {
    const pose = poseAt(content.motion, 0, HERE, new Float32Array(content.motion.nodes * 3));
    const view = new FigureView(content.figure, content.joints, content.parts, pose, style);
    this.#scene.add(view.group);
    return view;
  }

  /** Removes all figures. */
  #clear(): void {
    for (const figure of [this.#figure, this.#ghost, ...this.#marked, ...this.#futures]) figure?.dispose();
    [this.#figure, this.#ghost, this.#marked, this.#futures] = [null, null, [], []];
    [this.#figureOf, this.#markedOf] = [null, null];
  }

  /** Makes the figures of the stage's content. */
  update(): void {
    this.#viewport.changed();
    const { content } = this.#store;
    if (!content) return;
    this.#updateFigure(content);
    this.#takeLook();
    this.#updateGhost(content);
    this.#updateFutures(content);
    this.#updateMarked(content);
    this.#fade(this.#marked.length > 0 ? { opacity: 0.12 } : this.#store.fade);
  }

  #fade(fade: { opacity: number; part?: number } | null): void {
    if (fade === this.#faded) return;
    this.#faded = fade;
    this.#figure?.fade(1);
    if (fade) this.#figure?.fade(fade.opacity, fade.part);
  }

  #updateFigure(content: StageContent): void {
    const before = this.#figureOf;
    if (before === content) return;
    this.#figureOf = content;
    if (!before || !sameBody(before, content)) {
      this.#clear();
      this.#figureOf = content;
      this.#figure = this.#make(content, { kind: "solid" });
      this.#faded = null;
      this.#floor = floorOf(content.motion) - SOLE;
      this.#feet = feetOf(content.motion, this.#floor + SOLE);
      this.#ground.group.position.y = this.#floor;
    }
    if (!this.#placed) this.#placeCamera(content);
    else if (before?.clip !== content.clip || before?.motion.nodes !== content.motion.nodes) {
      this.#moveCamera(() => this.#framing.start(content.motion));
      this.#frame(content);
    } else if (!content.live) this.#framing.wanted = this.#view(content.motion);
  }

  #updateGhost(content: StageContent): void {
    if (this.#store.ghost) {
      this.#ghost ??= this.#make(content, { kind: "ghost" });
    } else {
      this.#ghost?.dispose();
      this.#ghost = null;
    }
  }

  #updateFutures(content: StageContent): void {
    const count = content.kind === "model" && !content.live ? this.#store.futures.length : 0;
    for (const figure of this.#futures.splice(count)) figure.dispose();
    while (this.#futures.length < count)
      this.#futures.push(this.#make(content, { kind: "future", index: this.#futures.length }));
  }

  /** The poses of an inducing point. */
  #updateMarked(content: StageContent): void {
    const marks = content.kind === "model" ? this.#store.marks : null;
    if (this.#markedOf === marks) return;
    this.#markedOf = marks;
    for (const figure of this.#marked) figure.dispose();
    this.#marked = (marks?.poses ?? []).map(({ part, opacity }) =>
      this.#make(content, { kind: "accent", part, opacity }),
    );
  }

  /** The share of the height by which the figure is lower in the picture. */
  get #lower(): number {
    return this.#viewport.size.height < LOW_PICTURE ? LOWER : 0;
  }

  /** The view in which the camera sees the whole motion. */
  #view(motion: Motion): View {
    const { camera, controls } = this.#viewport;
    const slope = Math.tan((camera.fov * Math.PI) / 360);
    const least = camera.aspect < 0.9 ? NEAR_HIGH : NEAR;
    const view = viewOf(motion, this.#floor, { slope, aspect: camera.aspect, shift: this.#lower });
    return { ...view, distance: Math.min(controls.maxDistance, Math.max(least, view.distance)) };
  }

  /** Shows the whole motion, from the same side. */
  #frame({ motion }: StageContent): void {
    this.#framing.wanted = this.#view(motion);
    this.#moveCamera(() => this.#framing.approach());
  }

  /** Changes the vector from the centre of the picture to the camera, and the height of the centre. */
  #moveCamera(change: () => void): void {
    const { camera, controls } = this.#viewport;
    const { offset } = this.#framing;
    offset.subVectors(camera.position, controls.target);
    change();
    this.#focus.y = this.#floor + this.#framing.middle;
    controls.target.copy(this.#focus);
    camera.position.addVectors(this.#focus, offset);
  }

  /** Places the camera at the side of the walk, a little in front. */
  #placeCamera(content: StageContent): void {
    const { pose } = this.#playback;
    if (!pose) return;
    this.#focus.fromArray(pose);
    this.#root.copy(this.#focus);
    const { controls } = this.#viewport;
    this.#framing.wanted = this.#view(content.motion);
    this.#moveCamera(() => {
      this.#framing.start(content.motion);
      this.#framing.approach();
      this.#framing.aim(SIDE);
    });
    controls.update();
    this.#placed = true;
  }

  /** Turns the camera as a link wants it. */
  #takeLook(): void {
    const look = this.#placed ? this.#store.takeLook() : null;
    if (!look) return;
    this.#moveCamera(() => {
      this.#framing.approach();
      this.#framing.look = look;
    });
    this.#viewport.controls.update();
  }

  /** The place of a node in the picture, in pixels of the page; null before the first pose. */
  placeOf(node: number): { x: number; y: number } | null {
    const { pose } = this.#playback;
    if (!pose) return null;
    const { width, height } = this.#viewport.size;
    const seen = new Vector3().fromArray(pose, 3 * node).project(this.#viewport.camera);
    return { x: ((seen.x + 1) / 2) * width, y: ((1 - seen.y) / 2) * height };
  }

  /** The node nearest to a place in the picture; null if none is within `within` pixels. */
  nodeAt(x: number, y: number, within: number): number | null {
    const nodes = (this.#playback.pose?.length ?? 0) / 3;
    let best: { node: number; away: number } | null = null;
    for (let node = 0; node < nodes; node++) {
      const place = this.placeOf(node);
      const away = place ? Math.hypot(place.x - x, place.y - y) : Infinity;
      if (away < (best?.away ?? within)) best = { node, away };
    }
    return best?.node ?? null;
  }

  /** The shift of a node in metres for a drag in pixels, parallel to the picture. */
  dragged(node: number, dx: number, dy: number): [number, number, number] {
    const { camera, size } = this.#viewport;
    const { pose } = this.#playback;
    if (!pose) return [0, 0, 0];
    const seen = new Vector3().fromArray(pose, 3 * node).project(camera);
    const moved = new Vector3(
      seen.x + (2 * dx) / size.width,
      seen.y - (2 * dy) / size.height,
      seen.z,
    ).unproject(camera);
    const by = moved.sub(new Vector3().fromArray(pose, 3 * node));
    return [by.x, by.y, by.z];
  }

  /** Whether drags turn the camera. */
  set turns(on: boolean) {
    this.#viewport.controls.enableRotate = on;
  }

  /** Draws after a change. `seconds` since the last call. */
  draw(seconds: number): void {
    const viewport = this.#viewport;
    const quality = viewport.next(seconds, this.#playback.playing);
    if (quality === null) return;
    this.#drawShadows(quality);
    const { pose } = this.#playback;
    if (pose && this.#figure) this.#poseAll(pose, seconds);
    viewport.renderer.render(this.#scene, viewport.camera);
    viewport.finish();
  }

  #poseAll(pose: Float32Array, seconds: number): void {
    this.#figure?.pose(pose);
    this.#poseOther(this.#ghost, this.#store.ghost, pose);
    this.#futures.forEach((figure, i) => this.#poseOther(figure, this.#store.futures[i], pose));
    this.#marked.forEach((figure, i) => {
      const marked = this.#markedOf?.poses[i];
      if (marked) figure.pose(placed(marked.positions, pose));
    });
    this.#followWalk(pose, seconds);
    this.#keepFraming(pose, seconds);
    this.#ground.touch(pose, this.#marked.length > 0 ? [] : this.#feet, this.#floor);
  }

  /** On a slow machine the shadow is drawn in every third frame only. */
  #drawShadows(quality: Quality): void {
    const { renderer, drawn } = this.#viewport;
    renderer.shadowMap.autoUpdate = quality === "fine";
    renderer.shadowMap.needsUpdate = quality === "plain" && drawn % 3 === 0;
  }

  /** Poses a ghost or a future at the place of the figure on the stage. */
  #poseOther(figure: FigureView | null, motion: Motion | null | undefined, pose: Float32Array): void {
    if (!figure || !motion || motion.nodes * 3 !== pose.length) return;
    if (this.#otherPose.length !== pose.length) this.#otherPose = new Float32Array(pose.length);
    const { frame } = this.#playback;
    poseAt(motion, frame, HERE, this.#otherPose);
    figure.pose(poseAt(motion, frame, placeOnto(this.#otherPose, pose), this.#otherPose));
  }

  /** Keeps the camera's angle to the walk, and the whole motion in the picture. */
  #keepFraming(pose: Float32Array, seconds: number): void {
    const { content } = this.#store;
    if (!content) return;
    this.#sinceLook += seconds;
    if (content.live && this.#sinceLook > BETWEEN) {
      this.#framing.wanted = this.#view(content.motion);
      this.#sinceLook = 0;
    }
    this.#moveCamera(() => {
      // A recording keeps its own directions, also if the body turns round in it.
      if (!content.clip) this.#framing.follow(pose, seconds * this.#playback.speed);
      this.#framing.approach(this.#playback.playing ? seconds : Number.POSITIVE_INFINITY);
    });
  }

  /** Moves camera and light with the figure: smoothly during play, exactly for steps and scrubs. */
  #followWalk(pose: Float32Array, seconds: number): void {
    const { x, z } = new Vector3().fromArray(pose);
    let [dx, dz] = [x - this.#focus.x, z - this.#focus.z];
    if (Math.hypot(dx, dz) < 3) {
      const part = 1 - Math.exp(-9 * Math.min(seconds, 0.1));
      [dx, dz] = this.#playback.playing ? [part * dx, part * dz] : [x - this.#root.x, z - this.#root.z];
    }
    this.#root.set(x, 0, z);
    this.#focus.x += dx;
    this.#focus.z += dz;
    const { camera, controls } = this.#viewport;
    camera.position.x += dx;
    camera.position.z += dz;
    controls.target.copy(this.#focus);
    this.#ground.follow(x, z);
    this.#lights.follow(x, this.#floor, z);
  }
}

/** A marked pose at the place and in the direction of the figure. */
function placed(marked: Float32Array, pose: Float32Array): Float32Array {
  const motion: Motion = { positions: marked, frames: 1, nodes: marked.length / 3, frameTime: 1 };
  return poseAt(motion, 0, placeOnto(marked, pose), new Float32Array(marked.length));
}

/** Whether two motions have the same body. */
export function sameBody(a: StageContent, b: StageContent): boolean {
  return JSON.stringify([a.figure, a.joints, a.parts]) === JSON.stringify([b.figure, b.joints, b.parts]);
}
