// The menu Save writes some seconds of the stage as a video.
import assert from "node:assert/strict";
import { decodeFrames } from "modern-gif";
import { barriersNow, openedSite, ready, seldom } from "./site.mjs";

const site = openedSite();

seldom.it("saves a moving picture with its progress, as GIF where the browser writes no videos", async () => {
  const { page } = await site.visit({ seen: true });
  await ready(page);
  await page.locator("#open-more").click();
  await page.getByTestId("sound").click();
  await page.getByTestId("save").click();
  const item = page.getByTestId("save-film");
  await item.waitFor();
  assert.deepEqual(await barriersNow(page), []);
  const film = async () => {
    const coming = page.waitForEvent("download", { timeout: 60_000 });
    await item.click();
    await item.getByText(/^Recording, \d s left$/).waitFor();
    const download = await coming;
    const bytes = Buffer.concat(await (await download.createReadStream()).toArray());
    return { name: download.suggestedFilename(), bytes };
  };
  const video = await film();
  assert.match(video.name, /-10s\.(webm|mp4)$/);
  assert.ok(video.bytes.length > 20_000, "the film has pictures");
  assert.match(video.bytes.toString("latin1"), /A_OPUS|mp4a|Opus/, "the film has the sound of the page");

  await page.evaluate(() => Reflect.deleteProperty(window, "MediaRecorder"));
  const gif = await film();
  assert.match(gif.name, /-10s\.gif$/);
  const pictures = decodeFrames(gif.bytes).map(({ data }) => data);
  assert.ok(pictures.length > 10, `${pictures.length} pictures`);
  const colours = new Set(new Uint32Array(pictures[1]?.buffer ?? new ArrayBuffer(0)));
  assert.ok(colours.size > 5, "a figure on a ground");
  assert.notDeepEqual(pictures[1], pictures[9], "the figure moves");
});
