// A canvas with its renderer, its camera and the controls of the camera. It is drawn only after a change, in
// the best quality that the machine can draw in time.
import { PCFShadowMap, PerspectiveCamera, SRGBColorSpace, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { onThemeChange, type Theme, theme } from "../ui/palette";
import { type Quality, PictureQuality } from "./picture-quality";

/** Largest number of drawn pixels for each pixel of the page, each way. */
const PIXELS: Record<Quality, number> = { fine: 2, plain: 1, coarse: 0.5 };

const UP = new Vector3(0, 1, 0);
/** Rotations of the camera by keys: about the vertical axis, and up or down; radians. */
const TURNS: Record<string, [number, number]> = { a: [-0.12, 0], d: [0.12, 0], w: [0, -0.08], s: [0, 0.08] };
/** Factors of the distance of the camera, by keys. */
const ZOOMS: Record<string, number> = { "+": 0.9, "-": 1.1 };

export interface ViewportEvents {
  /** The canvas has another size in pixels of the page. */
  resized(width: number, height: number): void;
  /** The picture turned dark or light. */
  recoloured(): void;
}

export class Viewport {
  readonly renderer: WebGLRenderer;
  readonly camera = new PerspectiveCamera(30, 1, 0.1, 60);
  readonly controls: OrbitControls;
  readonly #pictureQuality = new PictureQuality();
  readonly #observer = new ResizeObserver(() => this.resize());
  readonly #listening = new AbortController();
  readonly #stopThemes: () => void;
  #dark: boolean | null;
  #quality: Quality = "fine";
  #changed = true;
  #drawn = 0;

  /**
   * Throws where the browser has no WebGL. The caller calls `resize` once the camera can be fitted. `dark`:
   * null follows the system.
   */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly events: ViewportEvents,
    dark: boolean | null = null,
  ) {
    this.#dark = dark;
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: true,
      stencil: true,
      powerPreference: "low-power",
    });
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.setClearColor(this.theme.ground);
    this.controls = new OrbitControls(this.camera, canvas);
    Object.assign(this.controls, {
      enablePan: false,
      minPolarAngle: 0.15,
      maxPolarAngle: Math.PI / 2 - 0.03,
      rotateSpeed: 0.8,
    });
    this.controls.addEventListener("change", () => this.changed());
    const { signal } = this.#listening;
    canvas.addEventListener("keydown", (event) => this.#turnByKey(event), { signal });
    canvas.addEventListener("webglcontextrestored", () => this.changed(), { signal });
    this.#observer.observe(canvas);
    this.#stopThemes = onThemeChange(() => {
      if (this.#dark === null) this.#recolour();
    });
  }

  /** The colours of the picture. */
  get theme(): Theme {
    return theme(this.#dark ?? undefined);
  }

  /** Whether the picture is dark; null: as the system asks. */
  get dark(): boolean | null {
    return this.#dark;
  }

  set dark(dark: boolean | null) {
    this.#dark = dark;
    this.#recolour();
  }

  #recolour(): void {
    this.renderer.setClearColor(this.theme.ground);
    this.events.recoloured();
    this.changed();
  }

  /** The number of drawn pictures. */
  get drawn(): number {
    return this.#drawn;
  }

  /** Size in pixels of the page. */
  get size(): { width: number; height: number } {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    return { width, height };
  }

  /** The picture is out of date. */
  changed(): void {
    this.#changed = true;
  }

  /** Fits pixels and camera to the size of the canvas. */
  resize(): void {
    const { width, height } = this.size;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(PIXELS[this.#quality], devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.#keepSize(width, height);
    this.events.resized(width, height);
    this.camera.updateProjectionMatrix();
    this.changed();
  }

  /** A canvas without a size in its style would grow with its pixels. */
  #keepSize(width: number, height: number): void {
    const { canvas, size } = this;
    if (size.width === width && size.height === height) return;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
  }

  /**
   * Called once a display frame, `seconds` after the last call. The quality of the picture; null: no picture.
   */
  next(seconds: number, playing: boolean): Quality | null {
    this.controls.update();
    const quality = this.#pictureQuality.next(seconds, this.#changed, playing);
    if (quality !== this.#quality) {
      this.#quality = quality;
      this.resize();
    }
    if (!this.#changed) return null;
    this.#changed = false;
    return quality;
  }

  /** The picture was drawn. */
  finish(): void {
    this.#drawn += 1;
    this.#pictureQuality.drawn();
  }

  #turnByKey(event: KeyboardEvent): void {
    const turn = TURNS[event.key];
    const zoom = this.controls.enableZoom ? ZOOMS[event.key] : undefined;
    if (!turn && !zoom) return;
    const { target } = this.controls;
    const offset = this.camera.position.clone().sub(target);
    if (zoom) offset.multiplyScalar(zoom);
    if (turn) {
      offset.applyAxisAngle(UP, turn[0]);
      offset.applyAxisAngle(UP.clone().cross(offset).normalize(), turn[1]);
    }
    this.camera.position.copy(target).add(offset);
    this.changed();
    event.preventDefault();
  }

  dispose(): void {
    this.#stopThemes();
    this.#listening.abort();
    this.#observer.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
  }
}
