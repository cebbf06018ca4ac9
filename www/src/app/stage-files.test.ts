import { expect, it } from "vitest";
import { FakeEngine, modelHash, modelText } from "../engine/engine.fake";
import { motionAccount, positionsCsv, rolloutCsv } from "./stage-files";

async function rolledOut(alpha: number[][] | null = null) {
  const engine = new FakeEngine();
  const { model } = await engine.openModel(modelText(3, 2), 300);
  const rollout = await engine.rollout({ frames: 2, sequence: 1, alpha, reading: "re-inferred" });
  return {
    model,
    rollout: { ...rollout, latents: [new Float64Array([1, 2, 3, 4.5]), new Float64Array([-1, 0, 0.5, 7])] },
  };
}

it("writes a row a frame, with the latents of every part and the weights of every expert", async () => {
  const { model, rollout } = await rolledOut([
    [0.5, 0.25],
    [0.5, 0.75],
  ]);
  const weights = "weight_lower_lower,weight_lower_upper,weight_upper_lower,weight_upper_upper";
  expect(rolloutCsv(model, rollout)).toBe(
    `frame,time,lower_0,lower_1,upper_0,upper_1,${weights}\r\n` +
      "0,0,1,2,-1,0,0.5,0.25,0.5,0.75\r\n" +
      `1,${1 / 30},3,4.5,0.5,7,0.5,0.25,0.5,0.75\r\n`,
  );
});

it("tells how a motion was made: model, clips, seed, couplings, reading, start", async () => {
  const alpha = [
    [1, 8],
    [4, 1],
  ];
  const { model, rollout } = await rolledOut(alpha);
  const account = JSON.parse(motionAccount(model, rollout, { version: "1.2.3", file: "a.bvh" }));
  expect(account).toMatchObject({
    motion: "a.bvh",
    program: "vCGPDM playground 1.2.3",
    model: { sha256: modelHash(3), trained_by: "fake", seed: 3 },
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
