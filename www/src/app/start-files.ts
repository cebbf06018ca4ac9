// The files that the page opens with: the first seconds of a walk, and the model that made them.
import { decodeFirstMotion } from "../stage/first-motion.js";
import type { StageContent } from "../stage/stage-store";

async function fetchStartFile(file: string): Promise<Response | null> {
  const answer = await fetch(new URL(`first/${file}`, document.baseURI));
  return answer.ok ? answer : null;
}

/** The JSON document of the model; null: the host has none. */
export async function fetchStartModel(): Promise<string | null> {
  const answer = await fetchStartFile("model.json");
  return (await answer?.text()) ?? null;
}

/** The stored first seconds, shown until the model has arrived; null: the host has none. */
export async function fetchStartMotion(): Promise<StageContent | null> {
  const answer = await fetchStartFile("motion.bin");
  if (!answer) return null;
  const { figure, joints, parts, positions, frames, frameTime } = decodeFirstMotion(
    await answer.arrayBuffer(),
  );
  const motion = { positions, frames, nodes: figure.nodes.length, frameTime };
  return { kind: "first", figure, joints, parts, motion };
}
