// `npm run picture`: makes docs/playground.webp, the moving picture of the README. It steps the built page
// frame by frame in a headless Chromium, so that the picture is smooth on a slow machine too. The program
// sharp joins the pictures; the first run installs it into .tools.
import { mkdirSync, statSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { build } from "./build.mjs";
import { onPage } from "./chromium.mjs";
import { at, Failure, main, run, step, whenChanged } from "./run.mjs";
import { dist } from "./site.mjs";

const SHARP = "0.35.5";
const OUT = at("docs/playground.webp");
const MAX_BYTES = 1_000_000;
const SIZE = { width: 1200, height: 880 };
/** The picture is narrower than the page that it shows. */
const WIDTH = 900;
/** Frames of the motion (30 a second) from one picture to the next. */
const STEP = 3;
const QUALITY = 60;

/** In this number of pictures the pointer drags the arrow down by `down` pixels; with 0 the arrow rests. */
const SCENES = [
  { pictures: 14, down: 0 },
  { pictures: 9, down: 170 },
  { pictures: 26, down: 0 },
  { pictures: 7, down: -170 },
  { pictures: 12, down: 0 },
];

async function loadSharp() {
  const folder = at(".tools/picture");
  await whenChanged(
    "picture",
    { inputs: [], outputs: [at(".tools/picture/node_modules/sharp")], salt: SHARP },
    async () => {
      mkdirSync(folder, { recursive: true });
      writeFileSync(at(".tools/picture/package.json"), '{ "private": true }\n');
      const npm = process.env.npm_execpath;
      const args = ["install", "--prefix", folder, "--no-audit", "--no-fund", `sharp@${SHARP}`];
      await (npm ? run(process.execPath, npm, ...args) : run("npm", ...args));
    },
  );
  return createRequire(at(".tools/picture/package.json"))("sharp");
}

/** Draws a mouse pointer, which a browser without a window lacks. */
function pointer() {
  const dot = document.createElement("div");
  const look = {
    position: "fixed",
    width: "18px",
    height: "18px",
    left: "-99px",
    top: "0",
    "border-radius": "50%",
  };
  const more = {
    background: "rgb(30 30 30 / 45%)",
    border: "2px solid white",
    "z-index": "99",
    "pointer-events": "none",
  };
  for (const [name, value] of Object.entries({ ...look, ...more })) dot.style.setProperty(name, value);
  document.body.append(dot);
  addEventListener(
    "pointermove",
    ({ clientX, clientY }) => {
      dot.style.setProperty("left", `${clientX - 11}px`);
      dot.style.setProperty("top", `${clientY - 11}px`);
    },
    true,
  );
}

/** The pictures of the page in their order, as PNG. */
const pictures = () =>
  onPage(dist, { viewport: SIZE, reducedMotion: "reduce" }, async (page, address) => {
    await page.goto(`${address}?embed#view=play`);
    await page.waitForSelector("html[data-engine=ready]");
    await page.evaluate(pointer);
    const box = await page.getByTestId("arrow-0-1").boundingBox();
    if (!box) throw new Failure("the page shows no arrow");
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const found = [];
    for (const { pictures, down } of SCENES) {
      await page.mouse.move(x, y);
      // An arrow that is held without a move is cut.
      if (down !== 0) await page.mouse.down();
      for (let i = 1; i <= pictures; i++) {
        if (down !== 0) {
          await page.mouse.move(x, y + (down * i) / pictures);
          // Time for the new motion and its drawing.
          await page.waitForTimeout(250);
        }
        await page.evaluate((frames) => {
          const { clock } = /** @type {any} */ (document.querySelector("pg-page"));
          for (let k = 0; k < frames; k++) clock.step(1);
        }, STEP);
        await page.waitForTimeout(120);
        found.push(await page.screenshot({ type: "png" }));
      }
      if (down !== 0) await page.mouse.up();
    }
    return found;
  });

await main(async () => {
  await build();
  const sharp = await loadSharp();
  await step("docs/playground.webp", async () => {
    const found = await Promise.all(
      (await pictures()).map((png) => sharp(png).resize({ width: WIDTH }).png().toBuffer()),
    );
    const delay = found.map(() => Math.round((1000 * STEP) / 30));
    await sharp(found, { join: { animated: true } })
      .webp({ quality: QUALITY, effort: 6, smartSubsample: true, delay, loop: 0 })
      .toFile(OUT);
    const { size } = statSync(OUT);
    if (size > MAX_BYTES) throw new Failure(`docs/playground.webp has ${size} bytes, more than ${MAX_BYTES}`);
    return `${found.length} pictures, ${Math.round(size / 1000)} kB`;
  });
});
