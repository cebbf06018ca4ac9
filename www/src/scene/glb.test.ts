import { AnimationMixer, type SkinnedMesh, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { beforeAll, expect, it } from "vitest";
import type { Figure } from "../engine/protocol";
import { motionGlb } from "./glb";

/** Node has no FileReader, which the exporter needs. */
class FileReaderOfNode {
  result: ArrayBuffer | null = null;
  onloadend: () => void = () => {};
  readAsArrayBuffer(blob: Blob): void {
    void blob.arrayBuffer().then((bytes) => {
      this.result = bytes;
      this.onloadend();
    });
  }
}
beforeAll(() => {
  if (!("FileReader" in globalThis)) Object.assign(globalThis, { FileReader: FileReaderOfNode });
});

// z points up. In the second frame the body has moved, and turned by 90 degrees to the left.
const BVH = `HIERARCHY
ROOT hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT left_arm
  {
    OFFSET 10 0 50
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 30 0 0
    }
  }
  JOINT leg.1
  {
    OFFSET 0 5 -40
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 0 -45
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.5
0 0 90 0 0 0 0 0 0 0 0 0
100 20 90 90 0 0 0 0 0 0 0 0
`;

const node = (joint: number, parent: number | null, endSite = false) => ({ joint, parent, endSite });
const figure: Figure = { nodes: [node(0, null), node(1, 0), node(1, 1, true), node(2, 0), node(2, 3, true)] };

/** The positions in the units and axes of the file, computed by hand. */
const FIRST = [
  [0, 0, 90],
  [10, 0, 140],
  [40, 0, 140],
  [0, 5, 50],
  [0, 5, 5],
];
const turned = ([x = 0, y = 0, z = 0]: number[]) => [100 - y, 20 + x, z];
const SECOND = FIRST.map(turned);
/** The positions on the page: metres, y up, on the ground. */
const metres = ([x = 0, y = 0, z = 0]: number[]) => [x / 100 + 0.3, z / 100 - 0.05, -y / 100];
const positions = Float32Array.from([...FIRST, ...SECOND].flatMap(metres));

it("opens in three's own loader with the same places, for each up axis of the BVH", async () => {
  const parts = [{ name: "all", joints: [0, 1, 2] }];
  const motion = { positions, frames: 2, nodes: 5, frameTime: 0.5 };
  const bytes = await motionGlb(BVH, { figure, parts, motion });
  const { scene, animations } = await new GLTFLoader().parseAsync(bytes, "");
  const mixer = new AnimationMixer(scene);
  const [clip] = animations;
  expect(clip?.duration).toBe(0.5);
  if (clip) mixer.clipAction(clip).play();
  const names = ["hips", "left_arm", "left_arm_end", "leg1", "leg1_end"];
  [FIRST, SECOND].forEach((expected, frame) => {
    mixer.setTime(0.4999999 * frame);
    scene.updateMatrixWorld(true);
    names.forEach((name, i) => {
      const found = scene.getObjectByName(name)?.getWorldPosition(new Vector3()).toArray() ?? [];
      metres(expected[i] ?? []).forEach((value, axis) => {
        expect(found[axis]).toBeCloseTo(value, 4);
      });
    });
  });
  // Four bones with eight triangles each, and with one bone for each corner.
  const skin = scene.getObjectByProperty("type", "SkinnedMesh") as SkinnedMesh;
  expect(skin).toMatchObject({ geometry: { attributes: { position: { count: 96 } } } });
  // All nodes have x >= 0, so only the thickness of the bones reaches below 0. The thickest is 45 cm long.
  skin.geometry.computeBoundingBox();
  const { x } = skin.geometry.boundingBox!.min;
  expect(x).toBeLessThan(-0.05 * 45);
  expect(x).toBeGreaterThan(-0.15 * 45);
});

it("refuses a text without a skeleton", async () => {
  const motion = { positions, frames: 2, nodes: 5, frameTime: 0.5 };
  await expect(motionGlb("", { figure, parts: [], motion })).rejects.toThrow();
});
