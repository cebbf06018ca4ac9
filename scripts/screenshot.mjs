// `npm run screenshot -- OUT.png [--size 1440x900] [--dark] [--at story=2] [--language de]`: takes a picture of
// the built page after three seconds. Without `--at` it is the first view of a new visitor.
import { parseArgs } from "node:util";
import { launchChromium } from "./chromium.mjs";
import { Failure, main } from "./run.mjs";
import { serve } from "./serve.mjs";
import { dist } from "./site.mjs";

await main(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      size: { type: "string", default: "1440x900" },
      dark: { type: "boolean", default: false },
      at: { type: "string", default: "" },
      language: { type: "string", default: "en" },
    },
  });
  const [out] = positionals;
  const [, width, height] = values.size.match(/^(\d+)x(\d+)$/) ?? [];
  if (!out || !width || !height)
    throw new Failure(
      "usage: npm run screenshot -- OUT.png [--size 1440x900] [--dark] [--at story=2] [--language de]",
    );
  const { address, close } = await serve(dist);
  const browser = await launchChromium();
  try {
    const page = await browser.newPage({
      viewport: { width: Number(width), height: Number(height) },
      locale: values.language,
      colorScheme: values.dark ? "dark" : "light",
    });
    await page.goto(values.at ? `${address}#${values.at}` : address);
    await page.waitForSelector("html[data-engine=ready], .story[data-state=open], .teach[data-state=open]");
    await page.waitForTimeout(3000);
    await page.screenshot({ path: out });
    console.log(`wrote ${out}`);
  } finally {
    await browser.close();
    await close();
  }
});
