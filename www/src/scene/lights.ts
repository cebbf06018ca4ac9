// The light over a figure: a sky, and a sun whose shadow follows the figure.
import { DirectionalLight, HemisphereLight, type Scene } from "three";
import { theme } from "../ui/palette";

export class Lights {
  readonly #sun = new DirectionalLight(0xffffff, 2.1);
  readonly #sky = new HemisphereLight(0xffffff, 0xb8b2a6, 1.5);

  /** `fineness`: pixels of the shadow, each way. */
  constructor(scene: Scene, fineness: number, colours = theme()) {
    const { shadow } = this.#sun;
    this.#sun.castShadow = true;
    shadow.mapSize.set(fineness, fineness);
    Object.assign(shadow, { radius: 5, bias: -0.0005, normalBias: 0.02 });
    const view = shadow.camera;
    [view.left, view.right, view.top, view.bottom, view.near, view.far] = [-1.6, 1.6, 1.9, -1.3, 0.5, 9];
    scene.add(this.#sky, this.#sun, this.#sun.target);
    this.recolour(colours);
  }

  recolour({ dark } = theme()): void {
    this.#sky.intensity = dark ? 1.15 : 1.6;
    this.#sky.groundColor.set(dark ? 0x2a2d33 : 0xc9c3b8);
    this.#sun.intensity = dark ? 2.0 : 2.1;
  }

  /** Moves the light to a figure at this place. */
  follow(x: number, floor: number, z: number): void {
    this.#sun.target.position.set(x, floor + 0.6, z);
    this.#sun.position.set(x + 1.6, floor + 4.4, z + 1.3);
  }

  dispose(): void {
    this.#sun.shadow.dispose();
  }
}
