// Files and links: saved files have the motion on the stage, and a link names its model.
import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { describe, it } from "node:test";
import { AnimationMixer, PropertyBinding, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { at } from "../../scripts/run.mjs";
import { dist } from "../../scripts/site.mjs";
import { bvh } from "./clips.mjs";
import {
  drop,
  oneVisitor,
  openPanel,
  openedSite,
  ready,
  readyVisitor,
  saved,
  seldom,
  soon,
} from "./site.mjs";

const site = openedSite();

/** The largest distance in metres between joints in three's loader and in the table, in some frames. */
async function farthest(
  /** @type {Buffer} */ glb,
  /** @type {string[]} */ header,
  /** @type {string[]} */ rows,
) {
  const { scene, animations } = await new GLTFLoader().parseAsync(new Uint8Array(glb).buffer, "");
  const mixer = new AnimationMixer(scene);
  for (const clip of animations) mixer.clipAction(clip).play();
  const joints = header.flatMap((name, i) => (/_x$/.test(name) ? [{ name: name.slice(0, -2), at: i }] : []));
  assert.ok(joints.length > 15 && animations.length === 1);
  let most = 0;
  for (const frame of [0, Math.floor(rows.length / 2), rows.length - 2]) {
    const values = (rows[frame] ?? "").split(",").map(Number);
    mixer.setTime(values[1] ?? 0);
    scene.updateMatrixWorld(true);
    for (const { name, at } of joints) {
      const found = scene
        .getObjectByName(PropertyBinding.sanitizeNodeName(name))
        ?.getWorldPosition(new Vector3());
      assert.ok(found, `${name} is there`);
      most = Math.max(most, found.distanceTo(new Vector3().fromArray(values, at)));
    }
  }
  return most;
}

const frames = (/** @type {string} */ bvh) => Number(/^Frames: (\d+)$/m.exec(bvh)?.[1]);

describe("the first model", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit()));

  it("is saved, and so is a trimmed clip, with the same joints in GLB and table", async () => {
    const { page } = visitor;
    const same = async (/** @type {number} */ count) => {
      const glb = await saved(page, "save-glb");
      const table = await saved(page, "save-positions");
      assert.match(glb.name, /\.glb$/);
      assert.equal(glb.name.replace(".glb", ""), table.name.replace(".positions.csv", ""));
      const [header = "", ...rows] = table.text.trim().split("\r\n");
      assert.equal(rows.length, count);
      const apart = await farthest(glb.bytes, header.split(","), rows);
      assert.ok(apart < 1e-4, `joints are ${apart} m apart`);
    };
    const model = await saved(page, "save-motion");
    assert.equal(frames(model.text), 300);
    await same(300);
    await openPanel(page, "learn");
    await page.getByText("Samples, made by a program").click();
    await page
      .getByRole("button", { name: /^Show / })
      .first()
      .click();
    const whole = await saved(page, "save-motion");
    assert.notEqual(frames(whole.text), 300);
    await page.getByTestId("trim-first").fill("20");
    await page.getByTestId("trim-end").fill("60");
    const cut = await saved(page, "save-motion");
    assert.equal(frames(cut.text), 40);
    assert.match(cut.name, /-21-60\.bvh$/);
    await same(40);
    await page.getByRole("button", { name: "Back to the model" }).click();
    assert.deepEqual(await saved(page, "save-motion"), model);
  });

  seldom.it("has files with different names for variants, and an account that matches", async () => {
    const { page } = visitor;
    const learned = await saved(page, "save-motion");
    const document = await saved(page, "save-model");
    await page.getByTestId("coupling-0-1").fill("-2.5");
    const changed = await saved(page, "save-motion");
    assert.notEqual(changed.name, learned.name);
    const account = JSON.parse((await saved(page, "save-account")).text);
    assert.equal(account.motion, changed.name);
    const { createHash } = await import("node:crypto");
    assert.equal(account.model.sha256, createHash("sha256").update(document.text).digest("hex"));
    assert.ok(changed.name.includes(account.model.sha256.slice(0, 8)));
    const table = (await saved(page, "save-latents")).text.trim().split("\r\n");
    assert.equal(table.length, 301);
    assert.match(table[0] ?? "", /^frame,time,lower_0,.*weight_upper_upper$/);
    await page.keyboard.press("0");
    assert.equal((await saved(page, "save-motion")).name, learned.name);
  });

  it("has files as long as the visitor says", async () => {
    const { page } = visitor;
    await page.getByTestId("length").fill("5");
    await page.getByTestId("length").press("Enter");
    await page.waitForURL(/frames=150/);
    assert.equal(frames((await saved(page, "save-motion")).text), 150);
  });

  it("has sliders that strengthen to the right and up, with the weakest at Home and the strongest at End", async () => {
    const { page } = visitor;
    const slider = page.getByTestId("coupling-1-1");
    const alpha = async () => Number(await page.getByTestId("alpha-1-1").innerText());
    await slider.focus();
    for (const [key, holds] of /** @type {[string, (now: number, before: number) => boolean][]} */ ([
      ["ArrowRight", (now, before) => now < before],
      ["ArrowLeft", (now, before) => now > before],
      ["ArrowUp", (now, before) => now < before],
      ["ArrowDown", (now, before) => now > before],
    ])) {
      const was = await alpha();
      for (let i = 0; i < 3; i++) await page.keyboard.press(key);
      assert.ok(holds(await alpha(), was), `${key}: ${was} to ${await alpha()}`);
    }
    await page.keyboard.press("Home");
    assert.equal(await alpha(), 1000);
    await page.keyboard.press("End");
    assert.equal(await alpha(), 0.001);
  });

  it("is trained with numbers within their limits, which the field names", async () => {
    const { page } = visitor;
    await openPanel(page, "learn");
    await page.locator("pg-training .advanced summary").click();
    const field = page.getByTestId("setting-maxIterations");
    await field.fill("20000");
    await field.press("Enter");
    assert.equal(await field.inputValue(), "5000");
    await page.getByText("At most 5,000.").waitFor();
  });
});

describe("a folder from the visitor's disk", () => {
  seldom.it("gives the clips in it and in the folders below", async () => {
    const folder = mkdtempSync(join(tmpdir(), "vcgpdm-folder-"));
    mkdirSync(join(folder, "inner"));
    writeFileSync(join(folder, "first.bvh"), bvh());
    writeFileSync(join(folder, "inner", "second.bvh"), bvh());
    writeFileSync(join(folder, "notes.txt"), "no clip");
    const { page } = await site.visit();
    await ready(page);
    // Only the browser's own protocol drops a real folder.
    const session = await page.context().newCDPSession(page);
    const data = { items: [], files: [folder], dragOperationsMask: 1 };
    for (const type of /** @type {const} */ (["dragEnter", "dragOver", "drop"]))
      await session.send("Input.dispatchDragEvent", { type, x: 640, y: 400, data });
    for (const name of ["first", "second"])
      await page.getByTestId("own-clips").getByText(name, { exact: true }).waitFor();
    assert.equal(await page.getByTestId("notice").count(), 0);
    rmSync(folder, { recursive: true });
  });
});

describe("a JSON file whose keys are sorted", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit()));
  /** As `jq -S` and Python's `sort_keys` write it. */
  const sorted = (/** @type {string} */ path) => {
    const text = readFileSync(join(dist, path), "utf8");
    return JSON.stringify(JSON.parse(text), (_, value) =>
      value && typeof value === "object" && !Array.isArray(value)
        ? Object.fromEntries(Object.entries(value).sort(([a], [b]) => (a < b ? -1 : 1)))
        : value,
    );
  };

  for (const [what, path, view] of /** @type {[string, string, string][]} */ ([
    ["a library of primitives", "primitives/library.json", "primitives"],
    ["results of a comparison", "comparison/walks.results.json", "compare"],
    ["a study", "study/walks.study.json", "perception"],
  ]))
    seldom.it(`is opened as ${what}`, async () => {
      const { page } = visitor;
      await drop(page, { "sorted.json": sorted(path) });
      await page.waitForURL(new RegExp(`view=${view}`));
      assert.equal(await page.getByTestId("notice").count(), 0);
    });
});

describe("a link", () => {
  seldom.it("to another model's couplings leaves this model as it is, with a notice", async () => {
    const { page, leave } = await site.visit({ settings: "model=00000000&alpha=0.1:50" });
    await ready(page);
    assert.match(await page.getByTestId("foreign-link").innerText(), /another model \(00000000\)/);
    assert.notEqual(Number(await page.getByTestId("alpha-0-1").textContent()), 50);
    await openPanel(page, "learn");
    // The address keeps these couplings: a reload once lost them.
    await page.getByTestId("setting-latent").fill("2");
    await page.getByTestId("setting-latent").press("Enter");
    await page.waitForURL(/latent=2/);
    await page.reload();
    await ready(page);
    assert.match(await page.getByTestId("foreign-link").innerText(), /another model \(00000000\)/);
    await page.getByRole("button", { name: "Forget them" }).click();
    await page.getByTestId("foreign-link").waitFor({ state: "detached" });
    await leave();
  });

  it("names the model of its couplings, and brings them back after a reload", async () => {
    const { page, leave } = await site.visit();
    await ready(page);
    await page.getByTestId("coupling-0-1").fill("-1.5");
    await page.waitForURL(/model=[0-9a-f]{8}.*alpha=0\.1:/);
    await page.reload();
    await ready(page);
    assert.equal(await page.getByTestId("foreign-link").count(), 0);
    assert.ok(Math.abs(Number(await page.getByTestId("alpha-0-1").textContent()) - 10 ** 1.5) < 0.1);
    await leave();
  });
});

describe("without a network", () => {
  seldom.it("Train says why it cannot, and Compare works when the network is back", async () => {
    const { page, leave } = await site.visit({ settings: "tab=learn" });
    await ready(page);
    await page.context().setOffline(true);
    await page.getByTestId("train").click();
    await page
      .getByTestId("progress")
      .filter({ hasText: /could not be loaded.*online/i })
      .waitFor({ timeout: 60_000 });
    await page.getByTestId("view-compare").click();
    await page.getByRole("alert").filter({ hasText: "could not be loaded" }).waitFor();
    await page.context().setOffline(false);
    // Some versions of Chromium load the view again by themselves, others keep the failed import.
    const compare = page.getByTestId("compare").and(page.locator(":enabled"));
    const reload = page.getByRole("button", { name: "Reload the page" });
    await compare.waitFor({ timeout: 5_000 }).catch(() => reload.click());
    await compare.waitFor({ timeout: 60_000 });
    await leave();
  });
});

seldom.it("a saved motion has names of joints that three.js moves", async () => {
  const { page } = await site.visit();
  await ready(page);
  const model = JSON.parse(readFileSync(at("www/first/model.json"), "utf8"));
  for (const joint of model.pose.skeleton.joints) joint.name = `mixamorig:${joint.name}`;
  const file = {
    name: "mixamo.json",
    mimeType: "application/json",
    buffer: Buffer.from(JSON.stringify(model)),
  };
  await page.getByTestId("open-model").setInputFiles(file);
  await soon(async () => {
    const { text } = await saved(page, "save-model");
    assert.match(text, /mixamorig:Hips/, "the model keeps its names");
  });
  const { text } = await saved(page, "save-motion");
  const names = [...text.matchAll(/(?:ROOT|JOINT) (.+)/g)].map(([, name]) => name);
  assert.equal(names.length, model.pose.skeleton.joints.length);
  assert.equal(names[0], "Hips");
  assert.ok(
    names.every((name) => PropertyBinding.sanitizeNodeName(name ?? "") === name),
    names.join(" "),
  );
});

seldom.it("a model of a kind without couplings moves, says so, and its motion is saved", async () => {
  const { page } = await site.visit();
  await ready(page);
  const documents = at("crate/vcgpdm/tests/library/documents");
  for (const [file, name] of [
    ["tmp", "TMP"],
    ["map-cgpdm", "MAP CGPDM"],
    ["dmp-discrete", "DMP (discrete)"],
    ["dmp-rhythmic", "DMP (rhythmic)"],
  ]) {
    await page.getByTestId("open-model").setInputFiles(join(documents, `${file}.json`));
    const title = page.getByTestId("stage-title");
    await title.getByText(`Made by a ${name}`, { exact: true }).waitFor({ timeout: 30_000 });
    assert.match(await page.getByTestId("lead").innerText(), /a motion that is hidden now/);
    const motion = await saved(page, "save-motion");
    assert.equal(motion.name, `${file}.bvh`);
    assert.ok(frames(motion.text) > 100 && !/NaN|inf/i.test(motion.text));
    const rows = (await saved(page, "save-positions")).text.trim().split("\r\n");
    assert.equal(rows.length - 1, frames(motion.text));
    const handles = page.getByTestId("handles");
    const asLearned = page.getByTestId("handles-reset");
    if (file === "map-cgpdm") {
      // Its couplings can be changed.
      await page.getByTestId("map-coupling-0-1").press("End");
      await soon(async () => assert.notEqual((await saved(page, "save-motion")).text, motion.text));
      await asLearned.click();
      await soon(async () => assert.equal((await saved(page, "save-motion")).text, motion.text));
      continue;
    }
    await page.getByText("A model without couplings").waitFor();
    // A hand is lifted in one frame, and the tempo changed: another motion. A TMP has no goal.
    assert.equal(await page.getByTestId("drag-goal").count(), file === "tmp" ? 0 : 1);
    assert.equal(await asLearned.isEnabled(), false);
    await page.getByTestId("lift").click();
    await page.getByTestId("handle-tempo").fill("1");
    await handles.getByText("Tempo 2.00").waitFor();
    const changed = await saved(page, "save-motion");
    assert.equal(changed.name, `${file}-by-hand.bvh`);
    assert.notEqual(changed.text, motion.text);
    assert.ok(!/NaN|inf/i.test(changed.text));
    await asLearned.click();
    await handles.getByText("Tempo 1.00").waitFor();
    assert.equal((await saved(page, "save-motion")).text, motion.text);
  }
  await page.getByRole("button", { name: "Back to the model" }).click();
  await page.getByText("Made by the model").waitFor();
});
