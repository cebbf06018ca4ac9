// `npm run screenshot -- OUT.png [--size 1440x900] [--dark]`: takes a picture of the built page after three
// seconds.
import { parseArgs } from "node:util";
import { launchChromium } from "./chromium.mjs";
import { Failure, main } from "./run.mjs";
import { serve } from "./serve.mjs";
import { dist } from "./site.mjs";

await main(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { size: { type: "string", default: "1440x900" }, dark: { type: "boolean", default: false } },
  });
  const [out] = positionals;
  const [, width, height] = values.size.match(/^(\d+)x(\d+)$/) ?? [];
  if (!out || !width || !height)
    throw new Failure("usage: npm run screenshot -- OUT.png [--size 1440x900] [--dark]");
  const { address, close } = await serve(dist);
  const browser = await launchChromium();
  try {
    const page = await browser.newPage({
      viewport: { width: Number(width), height: Number(height) },
      colorScheme: values.dark ? "dark" : "light",
    });
    await page.goto(address);
    await page.waitForSelector("html[data-engine=ready]");
    await page.waitForTimeout(3000);
    await page.screenshot({ path: out });
    console.log(`wrote ${out}`);
  } finally {
    await browser.close();
    await close();
  }
});
