// A motion as a GLB file: the skeleton with its rotations, a simple skin in the colours of the parts, metres,
// y up. Loaded on demand. The skeleton comes from the motion's BVH, its size and place from the positions on
// the stage.
import {
  AnimationClip,
  type Bone,
  Color,
  Float32BufferAttribute,
  Group,
  type KeyframeTrack,
  Matrix4,
  MeshStandardMaterial,
  BufferGeometry,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  Vector3,
} from "three";
import { GLTFExporter } from "three/addons/exporters/GLTFExporter.js";
import { BVHLoader } from "three/addons/loaders/BVHLoader.js";
import type { Figure, Motion, PartSpec } from "../engine/protocol";
import { partColourNow } from "../ui/palette";
import { partOfJoints } from "./joints";

export interface MovedBody {
  figure: Figure;
  parts: readonly PartSpec[];
  motion: Motion;
}

/** Place and size of the largest width of a bone, as shares of its length. */
const WIDEST = 0.18;
const WIDTH = 0.09;
/** The colour of bones without a part. */
const NO_PART = "#9a9a9a";

/** The bytes of the file. `bvh` is the same motion as text. */
export async function motionGlb(bvh: string, { figure, parts, motion }: MovedBody): Promise<ArrayBuffer> {
  const { skeleton, clip } = new BVHLoader().parse(bvh);
  const { bones } = skeleton;
  const [root] = bones;
  if (!root) throw new Error("expected a motion with a skeleton, found none");
  const joints = bones.filter(({ name }) => name !== "ENDSITE");
  root.updateMatrixWorld(true);
  const skin = skinOf(bones, partOfBones(bones, joints, parts));
  const animation = animationOf(clip, joints);
  skin.add(root);
  // The skin is bound before it joins the group, so that the group moves bones and skin alike.
  skin.bind(new Skeleton(bones));
  const body = new Group();
  body.name = "body";
  body.add(skin);
  pose(animation.tracks, joints);
  root.updateMatrixWorld(true);
  place(body, joints.map(placeOf), jointsAt(figure, motion.positions, joints.length));
  for (const bone of bones) if (bone.name === "ENDSITE") bone.name = `${bone.parent?.name ?? ""}_end`;
  const options = { binary: true, trs: true, animations: [animation] };
  const file = await new GLTFExporter().parseAsync(body, options);
  if (!(file instanceof ArrayBuffer)) throw new Error("expected bytes, found text");
  return file;
}

const placeOf = (bone: Bone) => new Vector3().setFromMatrixPosition(bone.matrixWorld);

/** The part of the joint at the start of each bone; -1 without a part. */
function partOfBones(bones: readonly Bone[], joints: readonly Bone[], parts: readonly PartSpec[]): number[] {
  const part = partOfJoints(joints.length, parts);
  return bones.map((bone) => part[joints.indexOf(bone)] ?? -1);
}

/** World positions of the joints in the first frame. */
function jointsAt({ nodes }: Figure, positions: Float32Array, joints: number): Vector3[] {
  const places = Array.from({ length: joints }, () => new Vector3());
  nodes.forEach(({ joint, endSite }, node) => {
    if (!endSite) places[joint]?.fromArray(positions, 3 * node);
  });
  return places;
}

/** The tracks that are not constant, with unique bone names, because loaders change names. */
function animationOf(clip: AnimationClip, joints: readonly Bone[]): AnimationClip {
  // The loader makes two tracks for each joint, in order: position and rotation.
  const tracks = clip.tracks.flatMap((track, i) => {
    const bone = joints[Math.floor(i / 2)];
    const isPosition = i % 2 === 0;
    if (!bone || (isPosition && rests(track, bone.position))) return [];
    track.name = `${bone.uuid}.${isPosition ? "position" : "quaternion"}`;
    return [track];
  });
  return new AnimationClip("motion", -1, tracks);
}

function rests({ values }: KeyframeTrack, at: Vector3): boolean {
  const place = at.toArray();
  return values.every((value, i) => Math.abs(value - (place[i % 3] ?? 0)) < 1e-9);
}

/** Sets the joints to the first frame. */
function pose(tracks: readonly KeyframeTrack[], joints: readonly Bone[]): void {
  for (const { name, values } of tracks) {
    const bone = joints.find(({ uuid }) => name.startsWith(uuid));
    if (name.endsWith("position")) bone?.position.fromArray(values);
    else bone?.quaternion.fromArray(values);
  }
}

/** Shifts, rotates and scales a group so that the places `from` in it move to `to`. */
function place(group: Group, from: readonly Vector3[], to: readonly Vector3[]): void {
  const [a, b, c] = corners(from);
  const [before, after] = [frameOf(from, a, b, c), frameOf(to, a, b, c)];
  const size = (places: readonly Vector3[]) => places[a]?.distanceTo(places[b] ?? new Vector3()) ?? 1;
  group.scale.setScalar(size(to) / size(from));
  group.quaternion.setFromRotationMatrix(after.multiply(before.transpose()));
  const place = (from[a] ?? new Vector3()).clone().multiply(group.scale).applyQuaternion(group.quaternion);
  group.position.copy(to[a] ?? new Vector3()).sub(place);
}

/** Three places of a large triangle: the first, the farthest from it, and the farthest from their line. */
function corners(places: readonly Vector3[]): [number, number, number] {
  const origin = places[0] ?? new Vector3();
  const farthest = (away: (place: Vector3) => number) =>
    places.reduce((best, place, i) => (away(place) > away(places[best] ?? origin) ? i : best), 0);
  const b = farthest((place) => place.distanceTo(origin));
  const along = (places[b] ?? origin).clone().sub(origin).normalize();
  const c = farthest((place) => place.clone().sub(origin).cross(along).length());
  return [0, b, c];
}

/** The axes of a triangle of places, as columns. */
function frameOf(places: readonly Vector3[], a: number, b: number, c: number): Matrix4 {
  const [origin, second, third] = [a, b, c].map((i) => places[i] ?? new Vector3()) as [
    Vector3,
    Vector3,
    Vector3,
  ];
  const along = second.clone().sub(origin).normalize();
  const across = third.clone().sub(origin).cross(along).normalize();
  return new Matrix4().makeBasis(along, across, along.clone().cross(across));
}

/** One octahedron for each bone of the unposed skeleton, which moves with that bone alone. */
function skinOf(bones: readonly Bone[], part: readonly number[]): SkinnedMesh {
  const [points, colours, owners]: [number[], number[], number[]] = [[], [], []];
  bones.forEach((bone) => {
    const owner = bones.indexOf(bone.parent as Bone);
    if (owner < 0) return;
    const [from, to] = [placeOf(bone.parent as Bone), placeOf(bone)];
    const own = part[owner] ?? -1;
    const colour = new Color(own < 0 ? NO_PART : partColourNow(own)).toArray();
    for (const corner of octahedron(from, to)) {
      points.push(...corner.toArray());
      colours.push(...colour);
      owners.push(owner);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
  geometry.setAttribute("color", new Float32BufferAttribute(colours, 3));
  const four = (value: (owner: number) => number) => owners.flatMap((owner) => [value(owner), 0, 0, 0]);
  geometry.setAttribute(
    "skinIndex",
    new Uint16BufferAttribute(
      four((owner) => owner),
      4,
    ),
  );
  geometry.setAttribute(
    "skinWeight",
    new Float32BufferAttribute(
      four(() => 1),
      4,
    ),
  );
  geometry.computeVertexNormals();
  const skin = new SkinnedMesh(
    geometry,
    new MeshStandardMaterial({ vertexColors: true, roughness: 0.7, metalness: 0 }),
  );
  skin.name = "skin";
  return skin;
}

/** The corners of eight triangles, counter-clockwise from outside; none for a bone without length. */
function octahedron(from: Vector3, to: Vector3): Vector3[] {
  const along = to.clone().sub(from);
  const length = along.length();
  if (length < 1e-9) return [];
  along.divideScalar(length);
  const aside = new Vector3(1, 0, 0);
  if (Math.abs(along.x) > 0.9) aside.set(0, 1, 0);
  const right = along.clone().cross(aside).normalize();
  const front = along.clone().cross(right);
  const waist = from.clone().addScaledVector(along, WIDEST * length);
  const ring = [right, front, right.clone().negate(), front.clone().negate()].map((way) =>
    waist.clone().addScaledVector(way, WIDTH * length),
  );
  return ring.flatMap((corner, i) => {
    const next = ring[(i + 1) % 4] ?? corner;
    return [from, next, corner, to, corner, next];
  });
}
