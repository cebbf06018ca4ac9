// The ground: a grid that fades into the background, a shadow, and soft contact shades under the feet.
import {
  CircleGeometry,
  Color,
  DoubleSide,
  Group,
  type Material,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
  ShadowMaterial,
  Vector3,
} from "three";
import { theme } from "../ui/palette";

const REACH = 9;
/** Not larger than the shadow of the light, because each pixel is expensive. */
const SHADOW_REACH = 2;

const GRID_VERTEX = `
varying vec3 world;
void main() {
  vec4 at = modelMatrix * vec4(position, 1.0);
  world = at.xyz;
  gl_Position = projectionMatrix * viewMatrix * at;
}`;

const GRID_FRAGMENT = `
uniform vec3 colour;
uniform vec3 middle;
uniform float strength;
varying vec3 world;
float lines(vec2 at, float width) {
  vec2 pixel = fwidth(at);
  vec2 near = abs(fract(at - 0.5) - 0.5);
  vec2 line = 1.0 - smoothstep(vec2(width), vec2(width) + 1.5 * pixel, near);
  // Lines closer than pixels would flicker.
  line *= 1.0 - smoothstep(0.15, 0.5, pixel);
  return max(line.x, line.y);
}
void main() {
  float fade = 1.0 - smoothstep(1.2, ${REACH.toFixed(1)} * 0.8, distance(world.xz, middle.xz));
  float shade = max(0.45 * lines(world.xz * 2.0, 0.004), lines(world.xz * 0.5, 0.002));
  gl_FragColor = vec4(colour, strength * shade * fade * fade);
}`;

const CONTACT_FRAGMENT = `
uniform float strength;
varying vec2 at;
void main() {
  float shade = 1.0 - smoothstep(0.0, 1.0, length(at));
  gl_FragColor = vec4(0.0, 0.0, 0.0, strength * shade * shade);
}`;

const CONTACT_VERTEX = `
varying vec2 at;
void main() {
  at = position.xz;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

export class Ground {
  readonly group = new Group();
  readonly #grid: ShaderMaterial;
  readonly #plane: Mesh;
  readonly #shadow: Mesh<PlaneGeometry, ShadowMaterial>;
  #contacts: Mesh<CircleGeometry, ShaderMaterial>[] = [];
  #dark = false;

  constructor(colours = theme()) {
    this.#grid = new ShaderMaterial({
      vertexShader: GRID_VERTEX,
      fragmentShader: GRID_FRAGMENT,
      uniforms: { colour: { value: new Color() }, middle: { value: new Vector3() }, strength: { value: 1 } },
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    const flat = (reach: number) => new PlaneGeometry(2 * reach, 2 * reach).rotateX(-Math.PI / 2);
    this.#plane = new Mesh(flat(REACH), this.#grid);
    this.#plane.renderOrder = -3;
    this.#shadow = new Mesh(flat(SHADOW_REACH), new ShadowMaterial({ transparent: true, depthWrite: false }));
    this.#shadow.receiveShadow = true;
    this.#shadow.position.y = 0.001;
    this.#shadow.renderOrder = -2;
    this.group.add(this.#plane, this.#shadow);
    this.recolour(colours);
  }

  recolour({ dark } = theme()): void {
    this.#dark = dark;
    this.#grid.uniforms.colour!.value = new Color(dark ? "#9aa4ad" : "#6a737b");
    this.#grid.uniforms.strength!.value = dark ? 0.3 : 0.28;
    this.#shadow.material.opacity = dark ? 0.5 : 0.2;
  }

  /** Moves the centre under the figure; the lines keep their places in the world. */
  follow(x: number, z: number): void {
    this.#plane.position.set(x, 0, z);
    this.#shadow.position.set(x, 0.001, z);
    (this.#grid.uniforms.middle!.value as Vector3).set(x, 0, z);
  }

  /** A soft shade under each of these nodes, darker near the ground. */
  touch(positions: Float32Array, nodes: readonly number[], floor: number): void {
    while (this.#contacts.length < nodes.length) {
      const geometry = new CircleGeometry(1, 24).rotateX(-Math.PI / 2);
      const material = new ShaderMaterial({
        vertexShader: CONTACT_VERTEX,
        fragmentShader: CONTACT_FRAGMENT,
        uniforms: { strength: { value: 0 } },
        transparent: true,
        depthWrite: false,
      });
      const mesh = new Mesh(geometry, material);
      mesh.renderOrder = -1;
      this.#contacts.push(mesh);
      this.group.add(mesh);
    }
    const most = this.#dark ? 0.55 : 0.3;
    this.#contacts.forEach((mesh, i) => {
      const node = nodes[i];
      mesh.visible = node !== undefined;
      if (node === undefined) return;
      const height = Math.max(0, positions[3 * node + 1]! - floor - 0.02);
      mesh.position.set(positions[3 * node]!, 0.002 + 0.0002 * i, positions[3 * node + 2]!);
      mesh.scale.setScalar(0.1 + 0.25 * height);
      mesh.material.uniforms.strength!.value = most * Math.max(0, 1 - height / 0.22);
    });
  }

  dispose(): void {
    for (const mesh of [this.#plane, this.#shadow, ...this.#contacts]) {
      mesh.geometry.dispose();
      (mesh.material as Material).dispose();
    }
  }
}
