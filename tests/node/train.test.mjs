// What a JavaScript programmer tries first: any form of a file, one call for a training, no setting at all.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";
import { addresses, missing, withAddresses, zenodo } from "../../scripts/release.mjs";

const vcgpdm = builtPackage();

const SHORT = { latent: 2, dynamicsIps: 4, poseIps: 4, framesPerSecond: 15, maxIterations: 8 };

describe("one call", () => {
  it("reads a file as text, ArrayBuffer, bytes and Blob", async () => {
    const { Clip } = vcgpdm;
    const text = Clip.sample("walk-1").toBvh();
    const bytes = new TextEncoder().encode(text);
    const hash = Clip.sample("walk-1").info().sha256;
    for (const file of [text, bytes, bytes.buffer, Buffer.from(text)])
      assert.equal(Clip.read("a.bvh", /** @type {any} */ (file)).info().sha256, hash);
    assert.equal((await Clip.read("a.bvh", new Blob([text]))).info().sha256, hash);
    await assert.rejects(() => Clip.read("a.bvh", new Blob(["no motion"])), { code: "clip" });
  });

  it("trains as the steps do, and reports", async () => {
    const { Clip, train, Trainer, TrainingSet } = vcgpdm;
    const clips = [Clip.sample("walk-1").cut(0, 100), Clip.sample("walk-2").cut(0, 100)];
    /** @type {number[]} */
    const iterations = [];
    const onProgress = (/** @type {{ iteration: number }} */ { iteration }) => iterations.push(iteration);
    const papers = { poseWeight: 1, ownRollouts: false };
    const model = await train(clips, { ...SHORT, seed: 3, ...papers, onProgress });
    const set = new TrainingSet();
    for (const clip of clips) set.add(clip);
    const trainer = new Trainer(set, {
      ...SHORT,
      seed: 3,
      asInPapers: true,
      parts: "upper,lower".split(",").reverse().join(","),
    });
    while (!trainer.step().done);
    assert.equal(model.toJson(), trainer.model().toJson());
    assert.equal(iterations.at(-1), 8);
    assert.deepEqual(
      model.info().parts.map(({ name }) => name),
      ["lower", "upper"],
    );
    assert.equal(model.rollout().frames, 300);
    assert.equal(clips[0]?.info().frames, 100, "the clips can be used again");
  });

  // After 40 iterations this model visits 38 % of the poses of its clip.
  it("learns from the model's own rollouts at the end, unless told otherwise", async () => {
    const { Clip, train, Trainer, TrainingSet } = vcgpdm;
    const clip = Clip.sample("walk-1");
    const settings = { maxIterations: 40, poseWeight: 1 };
    const roundsOf = (/** @type {{ toJson(): string }} */ model) =>
      JSON.parse(model.toJson()).provenance.rollout_rounds;
    const plain = await train(clip, { ...settings, ownRollouts: false });
    assert.equal(plain.rollout({ frames: 600 }).health().state, "visits-few-poses");
    assert.equal(roundsOf(plain), undefined);
    const model = await train(clip, settings);
    assert.equal(model.rollout({ frames: 600 }).health().state, "moves-on");
    assert.ok(roundsOf(model) > 0);

    const set = new TrainingSet();
    set.add(clip);
    const trainer = new Trainer(set, settings);
    let progress = trainer.step();
    while (progress.phase !== "own-rollouts") progress = trainer.step();
    const error = trainer.rolloutError();
    assert.equal(trainer.model().rollout({ frames: 600 }).health().state, "visits-few-poses");
    while (!trainer.step().done);
    assert.equal(trainer.model().toJson(), model.toJson());
    assert.notEqual(trainer.rolloutError(), error, "that of the model that learned");
    await assert.rejects(() => train(clip, /** @type {any} */ ({ ownRollouts: 1 })), {
      message: /^settings: `ownRollouts`: .*found 1$/,
    });
  });

  it("has the settings that the library gives", () => {
    const { Clip, Trainer, TrainingSet, usualSettings } = vcgpdm;
    const set = new TrainingSet();
    set.add(Clip.sample("walk-1"));
    const trainer = new Trainer(set, { maxIterations: 1 });
    trainer.step();
    const { settings } = trainer.model().info().provenance;
    const { seed: _, parts: __, framesPerSecond: ___, ...found } = settings;
    assert.deepEqual(found, { ...usualSettings(3), maxIterations: 1 });
    assert.deepEqual(
      [settings.poseWeight, settings.ownRollouts, settings.dynamicsIps],
      ["balanced", true, 12],
    );
    assert.equal(usualSettings(8).dynamicsIps, 30);
  });

  it("gives the bound that every program gives with the usual settings", async () => {
    const { Clip, train } = vcgpdm;
    const golden = JSON.parse(readFileSync(at("tests/golden/defaults.json"), "utf8"));
    const clips = golden.clips.map((/** @type {string} */ id) => Clip.sample(id));
    const { bound } = (await train(clips, { maxIterations: golden.max_iterations })).info().provenance;
    assert.ok(Math.abs(bound / golden.bound - 1) < 1e-9, `${bound}`);
  });

  it("gives long clips more inducing points, unless told otherwise", () => {
    const { Clip, Trainer, TrainingSet } = vcgpdm;
    const points = (/** @type {string} */ text, settings = {}) => {
      const set = new TrainingSet();
      set.add(Clip.read("walk.bvh", text));
      const trainer = new Trainer(set, { framesPerSecond: 15, maxIterations: 1, ...settings });
      trainer.step();
      const { dynamicsIps, poseIps } = trainer.model().info().provenance.settings;
      return [dynamicsIps, poseIps];
    };
    const walk = Clip.sample("walk-1").toBvh();
    const slow = walk.replace(
      /Frame Time: .*/,
      `Frame Time: ${8.1 / Number(/Frames: (\d+)/.exec(walk)?.[1])}`,
    );
    assert.deepEqual(points(walk), [12, 12]);
    assert.deepEqual(points(slow), [30, 30]);
    assert.deepEqual(points(slow, { poseIps: 9 }), [30, 9]);
  });

  it("can be stopped", async () => {
    const { Clip, train } = vcgpdm;
    const stop = new AbortController();
    const onProgress = () => stop.abort(new RangeError("enough"));
    const training = train(Clip.sample("walk-1"), { maxIterations: 10_000, signal: stop.signal, onProgress });
    await assert.rejects(training, /enough/);
  });

  it("takes parts by the names of joints, and tables without parts", async () => {
    const { Clip, Table, train } = vcgpdm;
    const clip = Clip.sample("walk-1").cut(0, 100);
    const names = clip.info().joints.map(({ name }) => name);
    const parts = [
      { name: "legs", joints: names.filter((name) => /Leg|Foot|Toe/.test(name)) },
      { name: "rest", joints: names.flatMap((name, place) => (/Leg|Foot|Toe/.test(name) ? [] : [place])) },
    ];
    const model = await train(clip, { ...SHORT, parts });
    assert.deepEqual(
      model.info().parts.map(({ name }) => name),
      ["legs", "rest"],
    );
    const values = Float64Array.from({ length: 120 }, (_, at) => Math.sin(at / 7));
    const table = Table.of("waves", ["a", "b"], values, 0.05);
    const waves = await train(table, { ...SHORT, framesPerSecond: 20 });
    assert.deepEqual(
      waves.info().parts.map(({ name }) => name),
      ["all"],
    );
  });

  it("says in a training what was unusual in the files", () => {
    const { Clip, Trainer, TrainingSet } = vcgpdm;
    const text = Clip.sample("walk-1").cut(0, 100).toBvh();
    const [hierarchy = "", motion = ""] = text.split("MOTION\n");
    const root = "ROOT Reference\n{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n";
    const [frames, time, ...rows] = motion.trimEnd().split("\n");
    const below = [frames, time, ...rows.map((row) => `0 ${row}`)].join("\n");
    const body = hierarchy.replace("HIERARCHY\nROOT ", "JOINT ");
    const clip = Clip.read("still.bvh", `HIERARCHY\n${root}${body}}\nMOTION\n${below}\n`);
    assert.match(clip.info().warnings[0] ?? "", /^the root "Reference" only carries "Hips", which moves/);
    const set = new TrainingSet();
    set.add(clip);
    const notices = new Trainer(set, SHORT).notices();
    assert.match(notices[0] ?? "", /^still\.bvh: the root "Reference" only carries/);
  });

  it("sends a clip to a worker as plain data", () => {
    const { Clip } = vcgpdm;
    const clip = Clip.sample("walk-wave-1").cut(10, 90).withUp("-z");
    const again = Clip.fromState(structuredClone(clip.state()));
    assert.deepEqual(again.info(), clip.info());
    assert.equal(again.info().upAxis, "-z");
    assert.deepEqual(again.cut(0, 20).state().piece, [10, 30]);
  });
});

describe("the face", () => {
  const read = (/** @type {string} */ file) => readFileSync(at(file), "utf8");

  it("takes the addresses from Cargo.toml, once the owner is there", () => {
    const cargo = read("Cargo.toml");
    const citation = read("CITATION.cff");
    assert.equal(withAddresses(citation, cargo), citation, "node scripts/release.mjs writes it");
    assert.equal(zenodo(citation), read(".zenodo.json"), "node scripts/release.mjs writes it");
    const version = cargo.match(/^version = "(.*)"$/m)?.[1];
    assert.match(citation, new RegExp(`^version: ${version}$`, "m"));
    // A workspace of its own cannot take the version from the other one.
    assert.match(read("crate/python/Cargo.toml"), new RegExp(`^version = "${version}"$`, "m"));
    assert.deepEqual(addresses({ repository: "https://github.com/OWNER/a", homepage: "https://a" }), {});
    assert.deepEqual(addresses({ repository: "https://github.com/x/a", homepage: "https://a" }), {
      repository: { type: "git", url: "git+https://github.com/x/a.git" },
      homepage: "https://a",
      bugs: { url: "https://github.com/x/a/issues" },
    });
    assert.deepEqual(missing({ a: "by OWNER", b: "by x" }), ["a: expected the real value, found OWNER"]);
  });

  it("has the licence in published packages, and pins every action by its hash", () => {
    for (const folder of ["vcgpdm", "python"]) assert.equal(read(`crate/${folder}/LICENSE`), read("LICENSE"));
    for (const name of ["advisories", "pages", "release", "tests", "wheels"]) {
      const used = [...read(`.github/workflows/${name}.yml`).matchAll(/uses: (\S+)/g)].map(([, at]) => at);
      for (const action of used.filter((action) => !action?.startsWith("./")))
        assert.match(action ?? "", /^[\w/-]+@[0-9a-f]{40}$/, name);
    }
  });
});
