// A figure on the ground, with other motions of its body, and a camera that follows its walk.
import { Scene, Vector3 } from "three";
import type { Figure, Motion, PartSpec } from "../engine/protocol";
import { type FigureStyle, FigureView } from "./figure";
import { Follower, Framing } from "./framing";
import { Ground } from "./ground";
import { Lights } from "./lights";
import { HERE, placeOnto, poseAt } from "./motion";
import type { Quality } from "./picture-quality";
import { feetOf, floorOf, MIDDLE, SOLE, type View, viewOf } from "./stance";
import { Viewport } from "./viewport";

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

/** A motion with its body. */
export interface FigureMotion {
  figure: Figure;
  /** Names, in the order of the skeleton. */
  joints: readonly string[];
  parts: readonly PartSpec[];
  motion: Motion;
  /** The key of a clip. */
  clip?: string;
  /** Whether frames of the motion go on arriving. */
  live?: boolean;
}

/** The clock of the motion, and the pose of the figure now. */
export interface FigureClock {
  /** Node positions [nodes x 3]; null before the first motion. */
  readonly pose: Float32Array | null;
  readonly frame: number;
  readonly playing: boolean;
  /** Seconds of the motion in a second of the visitor's time; 0 while the clock stands. */
  readonly speed: number;
}

/** Another motion of the body, at the place of the figure. */
export interface Companion {
  style: FigureStyle;
  motion: Motion;
  /** Its frame now, null to hide it; absent: the frame of the clock. */
  frame?: () => number | null;
}

export class FollowedFigure {
  readonly viewport: Viewport;
  readonly #scene = new Scene();
  readonly #ground: Ground;
  readonly #lights: Lights;
  #figure: FigureView | null = null;
  #companions: (Companion & { view: FigureView })[] = [];
  /** The motion that the figure was made for. */
  #shown: FigureMotion | null = null;
  #feet: number[] = [];
  #floor = 0;
  readonly #focus = new Vector3(0, MIDDLE, 0);
  readonly #framing = new Framing(new Vector3());
  readonly #follower = new Follower();
  /** Seconds since the last look at the reach of a live motion. */
  #sinceLook = 0;
  /** The place of the figure in the last picture. */
  readonly #root = new Vector3();
  #placed = false;
  /** The pose of a companion. */
  #otherPose = new Float32Array(0);

  /**
   * Throws where the browser has no WebGL. `dark`: null follows the system. `recoloured` is called when all
   * figures were removed because the picture turned dark or light, and have to be shown again.
   */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly clock: FigureClock,
    recoloured: () => void,
    dark: boolean | null = null,
  ) {
    const resized = (width: number, height: number) => this.#fit(width, height);
    this.viewport = new Viewport(canvas, { resized, recoloured: () => this.#recolour(recoloured) }, dark);
    const { controls, theme } = this.viewport;
    const glide = { enableDamping: true, dampingFactor: 0.12 };
    Object.assign(controls, { ...glide, minDistance: 1.6, maxDistance: 12, zoomSpeed: 0.7 });
    controls.target.copy(this.#focus);
    this.#ground = new Ground(theme);
    this.#lights = new Lights(this.#scene, SHADOW, theme);
    this.#scene.add(this.#ground.group);
    this.viewport.resize();
  }

  /** Frees the graphics memory. */
  dispose(): void {
    this.#clear();
    this.#lights.dispose();
    this.#ground.dispose();
    this.viewport.dispose();
  }

  /** Lets the page scroll by wheel and finger over the canvas. */
  scrollsWithPage(): void {
    this.viewport.controls.enableZoom = false;
    this.viewport.canvas.style.touchAction = "pan-y";
  }

  /** The figure; null before the first motion. */
  get figure(): FigureView | null {
    return this.#figure;
  }

  /** From where the camera looks (`Framing.look`); null before the first figure. */
  get look(): readonly number[] | null {
    const { camera, controls } = this.viewport;
    this.#framing.offset.subVectors(camera.position, controls.target);
    return this.#placed ? this.#framing.look : null;
  }

  /** Turns the camera. It needs a figure. */
  lookFrom(look: readonly number[]): void {
    this.#moveCamera(() => {
      this.#framing.approach();
      this.#framing.look = look;
    });
    this.viewport.controls.update();
  }

  /** Makes another figure of the body of a motion. The caller disposes of it. */
  make({ figure, joints, parts, motion }: FigureMotion, style: FigureStyle): FigureView {
    const pose = poseAt(motion, 0, HERE, new Float32Array(motion.nodes * 3));
    const view = new FigureView(figure, joints, parts, pose, style, this.viewport.theme);
    this.#scene.add(view.group);
    return view;
  }

  /** Shows a motion. Returns whether its body is another one, so that a new figure was made. */
  show(next: FigureMotion): boolean {
    const before = this.#shown;
    if (before === next) return false;
    const isOther = !before || !sameBody(before, next);
    if (isOther) {
      this.#clear();
      this.#figure = this.make(next, { kind: "solid" });
      this.#floor = floorOf(next.motion) - SOLE;
      this.#feet = feetOf(next.motion, this.#floor + SOLE);
      this.#ground.group.position.y = this.#floor;
    }
    this.#shown = next;
    this.viewport.changed();
    if (!this.#placed) this.#placeCamera(next);
    else if (before?.clip !== next.clip || before?.motion.nodes !== next.motion.nodes) {
      this.#moveCamera(() => this.#framing.start(next.motion));
      this.#frame(next);
    } else if (!next.live) this.#framing.wanted = this.#view(next.motion);
    return isOther;
  }

  /** Draws these motions of the same body with the figure, and no others. */
  accompany(companions: readonly Companion[]): void {
    const shown = this.#shown;
    if (!shown) return;
    const styles = (all: readonly Companion[]) => JSON.stringify(all.map(({ style }) => style));
    const same = styles(companions) === styles(this.#companions);
    const views = this.#companions.map(({ view }) => view);
    if (!same) for (const view of views) view.dispose();
    this.#companions = companions.map((companion, i) => {
      const view = same ? views[i] : undefined;
      return { ...companion, view: view ?? this.make(shown, companion.style) };
    });
    this.viewport.changed();
  }

  /** Removes all figures. */
  #clear(): void {
    this.#figure?.dispose();
    for (const { view } of this.#companions) view.dispose();
    [this.#figure, this.#companions, this.#shown] = [null, [], null];
  }

  #recolour(recoloured: () => void): void {
    const { theme } = this.viewport;
    this.#lights.recolour(theme);
    this.#ground.recolour(theme);
    this.#clear();
    recoloured();
  }

  /** The share of the height by which the figure is lower in the picture. */
  get #lower(): number {
    return this.viewport.size.height < LOW_PICTURE ? LOWER : 0;
  }

  /** Fits the camera to the size of the picture. */
  #fit(width: number, height: number): void {
    const { camera } = this.viewport;
    camera.aspect = width / height;
    camera.setViewOffset(width, height, 0, -this.#lower * height, width, height);
    if (this.#shown && this.#placed) this.#frame(this.#shown);
  }

  /** The view in which the camera sees the whole motion. */
  #view(motion: Motion): View {
    const { camera, controls } = this.viewport;
    const slope = Math.tan((camera.fov * Math.PI) / 360);
    const least = camera.aspect < 0.9 ? NEAR_HIGH : NEAR;
    const view = viewOf(motion, this.#floor, { slope, aspect: camera.aspect, shift: this.#lower });
    return { ...view, distance: Math.min(controls.maxDistance, Math.max(least, view.distance)) };
  }

  /** Shows the whole motion, from the same side. */
  #frame({ motion }: FigureMotion): void {
    this.#framing.wanted = this.#view(motion);
    this.#moveCamera(() => this.#framing.approach());
  }

  /** Changes the vector from the centre of the picture to the camera, and the height of the centre. */
  #moveCamera(change: () => void): void {
    const { camera, controls } = this.viewport;
    const { offset } = this.#framing;
    offset.subVectors(camera.position, controls.target);
    change();
    this.#focus.y = this.#floor + this.#framing.middle;
    controls.target.copy(this.#focus);
    camera.position.addVectors(this.#focus, offset);
  }

  /** Places the camera at the side of the walk, a little in front. */
  #placeCamera({ motion }: FigureMotion): void {
    const { pose } = this.clock;
    if (!pose) return;
    this.#focus.fromArray(pose);
    this.#root.copy(this.#focus);
    this.#framing.wanted = this.#view(motion);
    this.#moveCamera(() => {
      this.#framing.start(motion);
      this.#framing.approach();
      this.#framing.aim(SIDE);
    });
    this.viewport.controls.update();
    this.#placed = true;
  }

  /**
   * Draws after a change. `seconds` since the last call. `posed` is called with the pose of a new picture;
   * without `feet` there are no shades under the feet.
   */
  draw(seconds: number, feet = true, posed = (_pose: Float32Array) => {}): void {
    const { viewport } = this;
    const quality = viewport.next(seconds, this.clock.playing);
    if (quality === null) return;
    this.#drawShadows(quality);
    const { pose } = this.clock;
    if (pose && this.#figure) {
      this.#figure.pose(pose);
      for (const companion of this.#companions) this.#poseCompanion(companion, pose);
      posed(pose);
      this.#followWalk(pose, seconds);
      this.#keepFraming(pose, seconds);
      this.#ground.touch(pose, feet ? this.#feet : [], this.#floor);
    }
    viewport.renderer.render(this.#scene, viewport.camera);
    viewport.finish();
  }

  /** On a slow machine the shadow is drawn in every third frame only, and when the clock stands. */
  #drawShadows(quality: Quality): void {
    const { renderer, drawn } = this.viewport;
    renderer.shadowMap.autoUpdate = quality === "fine";
    renderer.shadowMap.needsUpdate = quality === "plain" && (!this.clock.playing || drawn % 3 === 0);
  }

  /** Poses another motion at the place of the figure. */
  #poseCompanion(companion: Companion & { view: FigureView }, pose: Float32Array): void {
    const { view, motion } = companion;
    const frame = companion.frame ? companion.frame() : this.clock.frame;
    view.group.visible = frame !== null;
    if (frame === null) return;
    if (motion.nodes * 3 !== pose.length) return;
    if (this.#otherPose.length !== pose.length) this.#otherPose = new Float32Array(pose.length);
    poseAt(motion, frame, HERE, this.#otherPose);
    view.pose(poseAt(motion, frame, placeOnto(this.#otherPose, pose), this.#otherPose));
  }

  /** Keeps the camera's angle to the walk, and the whole motion in the picture. */
  #keepFraming(pose: Float32Array, seconds: number): void {
    const shown = this.#shown;
    if (!shown) return;
    this.#sinceLook += seconds;
    if (shown.live && this.#sinceLook > BETWEEN) {
      this.#framing.wanted = this.#view(shown.motion);
      this.#sinceLook = 0;
    }
    const { playing, speed } = this.clock;
    this.#moveCamera(() => {
      // A recording keeps its own directions, also if the body turns round in it.
      if (!shown.clip) this.#framing.follow(pose, seconds * speed);
      this.#framing.approach(playing ? seconds : Number.POSITIVE_INFINITY);
    });
  }

  /** Moves camera and light with the figure: smoothly during play, exactly for steps and scrubs. */
  #followWalk(pose: Float32Array, seconds: number): void {
    const { playing } = this.clock;
    const { x, z } = new Vector3().fromArray(pose);
    let [dx, dz] = [x - this.#focus.x, z - this.#focus.z];
    if (Math.hypot(dx, dz) > 3) this.#follower.stop();
    else if (playing) [dx, dz] = this.#follower.next(dx, dz, seconds);
    else [dx, dz] = [x - this.#root.x, z - this.#root.z];
    this.#root.set(x, 0, z);
    this.#focus.x += dx;
    this.#focus.z += dz;
    const { camera, controls } = this.viewport;
    camera.position.x += dx;
    camera.position.z += dz;
    controls.target.copy(this.#focus);
    this.#ground.follow(x, z);
    this.#lights.follow(x, this.#floor, z);
  }
}

/** Whether two motions have the same body. */
export function sameBody(a: FigureMotion, b: FigureMotion): boolean {
  return JSON.stringify([a.figure, a.joints, a.parts]) === JSON.stringify([b.figure, b.joints, b.parts]);
}
