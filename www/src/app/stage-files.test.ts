import { expect, it } from "vitest";
import { modelText } from "../engine/documents.fake";
import { HeldWorkers } from "../engine/held.fake";
import { motionAccount, positionsCsv, rolloutCsv } from "./stage-files";

/** Two frames of a model, and its document. */
async function rolledOut(alpha: number[][] | null = null) {
  const { engine } = new HeldWorkers().started();
  const { model } = await engine.openModel(modelText(3, 2), 60);
  const rollout = await engine.rollout({ frames: 2, sequence: 1, alpha, reading: "re-inferred" });
  return { model, rollout, text: await engine.modelJson() };
}

it("writes a row a frame, with the latents of every part and the weights of every expert", async () => {
  const { model, rollout } = await rolledOut([
    [1, 8],
    [4, 1],
  ]);
  const [header, ...rows] = rolloutCsv(model, rollout).split("\r\n");
  const weights = "weight_lower_lower,weight_lower_upper,weight_upper_lower,weight_upper_upper";
  expect(header).toBe(`frame,time,lower_0,lower_1,upper_0,upper_1,${weights}`);
  expect(rollout.weights.flat()).toEqual(
    [0.8, 1 / 9, 0.2, 8 / 9].map((weight) => expect.closeTo(weight, 12)),
  );
  const latents = (frame: number) =>
    rollout.latents.flatMap((part) => [...part.slice(2 * frame, 2 * frame + 2)]);
  expect(rows).toEqual([
    ...[0, 1].map((frame) => [frame, frame / 2, ...latents(frame), ...rollout.weights.flat()].join()),
    "",
  ]);
});

it("tells how a motion was made: model, clips, seed, couplings, reading, start", async () => {
  const alpha = [
    [1, 8],
    [4, 1],
  ];
  const { model, rollout, text } = await rolledOut(alpha);
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", new TextEncoder().encode(text)));
  const sha256 = Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("");
  const account = JSON.parse(motionAccount(model, rollout, { version: "1.2.3", file: "a.bvh" }));
  expect(account).toMatchObject({
    motion: "a.bvh",
    program: "vCGPDM playground 1.2.3",
    model: { sha256, trained_by: "vcgpdm 0.1.0", seed: 3 },
    alpha,
    alpha_learned: model.info.alpha,
    reading: "re-inferred",
    start: { sequence: 1, name: "walk 1", frame: 0 },
    frames: 2,
  });
  expect(account.model.clips).toHaveLength(2);
  const learned = await rolledOut();
  const plain = JSON.parse(motionAccount(learned.model, learned.rollout, { version: "1", file: "b.bvh" }));
  expect([plain.alpha, plain.reading]).toEqual([learned.model.info.alpha, "as-learned"]);
  const { request } = learned.rollout;
  const about = { version: "1", file: "b.bvh", clip: "other" };
  const sampled = JSON.parse(
    motionAccount(learned.model, { ...learned.rollout, request: { ...request, sample: 3 } }, about),
  );
  expect([sampled.start, sampled.sample]).toEqual([{ clip: "other" }, 3]);
});

it("writes where every joint and end is, a row a frame", () => {
  const body = {
    joints: [{ name: "hips" }, { name: "head" }],
    figure: {
      nodes: [
        { joint: 0, parent: null, endSite: false },
        { joint: 1, parent: 0, endSite: false },
        { joint: 1, parent: 1, endSite: true },
      ],
    },
  };
  const positions = Float32Array.from({ length: 18 }, (_, i) => i / 2);
  const [header, first, second] = positionsCsv(body, {
    positions,
    frames: 2,
    nodes: 3,
    frameTime: 0.5,
  }).split("\r\n");
  expect(header).toBe(
    "frame,time,hips_x,hips_y,hips_z,head_x,head_y,head_z,head_end_x,head_end_y,head_end_z",
  );
  expect([first, second]).toEqual(["0,0,0,0.5,1,1.5,2,2.5,3,3.5,4", "1,0.5,4.5,5,5.5,6,6.5,7,7.5,8,8.5"]);
});
