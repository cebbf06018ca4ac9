// The menu Save writes some seconds of the stage as a video.
import assert from "node:assert/strict";
import { barriersNow, openedSite, ready, seldom } from "./site.mjs";

const site = openedSite();

seldom.it("saves a moving picture with its progress, or says that the browser cannot", async () => {
  const { page } = await site.visit({ seen: true });
  await ready(page);
  await page.getByTestId("save").click();
  const item = page.getByTestId("save-film");
  await item.waitFor();
  assert.deepEqual(await barriersNow(page), []);
  const coming = page.waitForEvent("download", { timeout: 60_000 });
  await item.click();
  await item.getByText(/^Recording, \d s left$/).waitFor();
  const film = await coming;
  assert.match(film.suggestedFilename(), /-10s\.(webm|mp4)$/);
  const bytes = await (await film.createReadStream()).toArray();
  assert.ok(Buffer.concat(bytes).length > 20_000, "the film has pictures");

  const other = await site.visit();
  await ready(other.page);
  await other.page.evaluate(() => Reflect.deleteProperty(window, "MediaRecorder"));
  await other.page.getByTestId("save").click();
  await other.page.getByTestId("save-film").getByText("This browser cannot write videos").waitFor();
  assert.equal(await other.page.getByTestId("save-film").isEnabled(), false);
});
