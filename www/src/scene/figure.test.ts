import { Mesh, type MeshBasicMaterial } from "three";
import { expect, it } from "vitest";
import { FigureView } from "./figure";

const figure = {
  nodes: [
    { joint: 0, parent: null, endSite: false },
    { joint: 1, parent: 0, endSite: false },
    { joint: 1, parent: 1, endSite: true },
  ],
};
const pose = new Float32Array([0, 1, 0, 0, 1.4, 0, 0, 1.7, 0]);

it("draws a ghost as an outline, which no solid body and not the ghost itself is behind", () => {
  const { group } = new FigureView(figure, ["hips", "spine"], [], pose, { kind: "ghost" });
  const meshes = group.children.filter((child): child is Mesh => child instanceof Mesh);
  const materialOf = (mesh: Mesh) => mesh.material as MeshBasicMaterial;
  const bodies = meshes.filter((mesh) => !materialOf(mesh).colorWrite);
  const rims = meshes.filter((mesh) => materialOf(mesh).colorWrite);
  expect(rims).toHaveLength(bodies.length);
  const [body, rim] = [bodies[0]!, rims[0]!];
  // The body is drawn first and keeps the rim off its pixels.
  expect(body.renderOrder).toBeLessThan(rim.renderOrder);
  expect(materialOf(rim).stencilRef).toBeLessThan(materialOf(body).stencilRef);
  for (const { geometry } of [body, rim]) geometry.computeBoundingSphere();
  expect(rim.geometry.boundingSphere!.radius).toBeGreaterThan(body.geometry.boundingSphere!.radius);
});

it("draws the other parts of a pale figure paler than the part it is about", () => {
  const opacity = (part: number) => {
    const style = { kind: "accent", part, opacity: 0.5 } as const;
    const parts = [{ name: "all", joints: [0, 1] }];
    const { group } = new FigureView(figure, ["hips", "spine"], parts, pose, style);
    const [mesh] = group.children.filter((child): child is Mesh => child instanceof Mesh);
    return (mesh!.material as MeshBasicMaterial).opacity;
  };
  expect([opacity(0), opacity(1)]).toEqual([0.5, 0.35 * 0.5]);
});
