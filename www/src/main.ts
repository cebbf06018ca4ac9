// Wiring: the first motion, the worker, the views, the clock.
import { html, render } from "lit";
import { loadSamples, openFiles } from "./clips/clips";
import { resetCouplings, takeUp } from "./couplings/rollouts";
import { App } from "./app/app";
import { listenToDrops } from "./app/dropping";
import { startEngine } from "./engine/engine";
import { decodeFirstMotion } from "./stage/first-motion.js";
import { messageOf } from "./ui/format";
import { listenToKeys } from "./app/keyboard";
import { isEmbedded, readSettings } from "./settings/settings";
import "./ui/base.css";
import "./app/layout.css";
import "./app/panels.css";
import "./app/page";
import type { PageView } from "./app/page";

const app = new App(readSettings(location.hash), isEmbedded(location.search));
const root = document.documentElement;
root.dataset["engine"] = "loading";
root.toggleAttribute("data-large", app.embedded);
app.player.playing = !matchMedia("(prefers-reduced-motion: reduce)").matches;

document.querySelector("#boot")?.remove();
render(html`<pg-page .app=${app}></pg-page>`, document.body);
const page = document.querySelector("pg-page") as PageView;

listenToKeys({
  togglePlay: () => page.clock?.togglePlay(),
  step: (direction) => page.clock?.step(direction),
  resetCouplings: () => page.clock === page.timeline && resetCouplings(app),
  help: () => page.help.open(),
  projector: () => root.toggleAttribute("data-large"),
});
listenToDrops((files, at) => void openFiles(app, files, at));
addEventListener("hashchange", () => {
  app.settings = readSettings(location.hash);
  app.player.speed = app.settings.speed;
  app.player.loops = app.settings.loop;
  if (app.model) takeUp(app, { model: app.model, rollout: app.learned! }, { couplings: true });
  app.tell("settings", "playback");
});

let before = performance.now();
function frame(now: number): void {
  const seconds = Math.min(0.25, (now - before) / 1000);
  before = now;
  if (app.settings.view === "play" || app.embedded) {
    app.advance(seconds);
    page.stage.draw(seconds);
  }
  requestAnimationFrame(frame);
}
requestAnimationFrame(frame);

/** The stored first seconds walk until the worker has rolled out the real thing. */
async function showFirstMotion(): Promise<void> {
  const answer = await fetch(new URL("first/motion.bin", document.baseURI));
  if (!answer.ok) return;
  const { figure, joints, parts, positions, frames, frameTime } = decodeFirstMotion(await answer.arrayBuffer());
  if (app.shown) return;
  const motion = { positions, frames, nodes: figure.nodes.length, frameTime };
  app.show({ kind: "first", figure, joints, parts, motion });
}

async function startModel(): Promise<void> {
  const text = fetch(new URL("first/model.json", document.baseURI)).then((answer) =>
    answer.ok ? answer.text() : null,
  );
  try {
    const { engine, pool, version, samples } = await startEngine();
    app.engine = engine;
    app.pool = pool;
    app.version = version;
    const model = await text;
    if (model !== null) takeUp(app, await engine.openModel(model, app.settings.frames), { couplings: true });
    app.engineState = "ready";
    root.dataset["engine"] = "ready";
    app.tell("engine");
    await loadSamples(app, samples);
  } catch (problem) {
    app.engineState = "failed";
    app.engineProblem = messageOf(problem);
    root.dataset["engine"] = "failed";
    app.tell("engine");
  }
}

showFirstMotion().catch(() => {
  // Only the head start is lost: the model rolls out its own motion as soon as it is there.
});
void startModel();
