// Starts the page: the stores, the story or the Lab, and the engine of the Lab at its first use.
import "./ui/base.css";
import "./ui/classes.css";
import "./ui/controls.css";
import "./app/layout.css";
import { html, render } from "lit";
import { App } from "./app/app";
import { wouldLose } from "./app/leaving";
import { openFiles } from "./app/open-files";
import type { PageView } from "./app/page";
import { fetchStartModel, fetchStartMotion } from "./app/start-files";
import { startEngine } from "./engine/engine";
import { hireWholeWorkers } from "./engine/whole-workers";
import { browserAddressBar } from "./settings/address";
import { openDoor } from "./settings/door";
import { isEmbedded } from "./settings/settings";
import { IN_LAB } from "./settings/settings-store";
import "./story/doors";
import { whenIdle, prefersReducedMotion } from "./ui/browser";
import type { Place } from "./ui/notices-store";
import { type DroppedFiles, droppedFiles } from "./app/dropped-files";

function listenToDrops(opened: (dropped: Promise<DroppedFiles>, at: Place) => Promise<void>): void {
  const page = document.documentElement;
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  // Each element under the pointer sends these events, so they are counted.
  let depth = 0;
  const show = (dragging: boolean) => page.toggleAttribute("data-dragging", dragging);
  document.addEventListener("dragenter", (event) => {
    if (!hasFiles(event)) return;
    depth += 1;
    show(true);
  });
  document.addEventListener("dragleave", (event) => {
    if (!hasFiles(event)) return;
    depth = Math.max(0, depth - 1);
    if (depth === 0) show(false);
  });
  document.addEventListener("dragover", (event) => {
    if (hasFiles(event)) event.preventDefault();
  });
  document.addEventListener("drop", (event) => {
    depth = 0;
    show(false);
    if (!hasFiles(event)) return;
    event.preventDefault();
    void opened(droppedFiles(event.dataTransfer?.items ?? []), { x: event.clientX, y: event.clientY });
  });
}

const app = new App(browserAddressBar, isEmbedded(location.search), hireWholeWorkers());
openDoor(app.settings, app.embedded);
const root = document.documentElement;
const showState = () => {
  root.dataset.engine = app.engine.state;
};
showState();
app.engine.on(showState);
const showType = () => root.toggleAttribute("data-large", app.settings.values.large);
showType();
app.settings.on(showType);

addEventListener("hashchange", () => app.followAddress());
// The browser asks whether to leave.
addEventListener("beforeunload", (event) => wouldLose(app) && event.preventDefault());

const start = () => app.start((events) => startEngine(app.workers, events), fetchStartModel);

let keepsFiles = false;
/** Keeps the files of the page for later visits, once the first engine runs or has failed. */
function keepFiles(): void {
  if (keepsFiles || !import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  keepsFiles = true;
  whenIdle(
    () => void app.offline.begin(async () => (await import("./offline/service-workers")).serviceWorkers()),
  );
}
app.story.engine.on(keepFiles);
app.engine.on(keepFiles);

/** Starts the engine of the Lab, when the Lab is on the page for the first time. */
function startLab(page: PageView): void {
  if (!prefersReducedMotion()) app.playback.play();
  // A load that failed may work now.
  addEventListener("online", () => void (app.engine.state === "failed" && start()));
  void start().then(() => {
    // A browser that stores nothing is no reason for a notice to a visitor with nothing to store.
    if (app.embedded || app.engine.state !== "ready") return;
    whenIdle(() => {
      app.session.get().then(
        (session) => {
          page.session = session;
        },
        () => {},
      );
    });
  });
  // The stored motion is not that of a link's model.
  if (app.settings.bringsModel) return;
  fetchStartMotion().then(
    (motion) => {
      // Until the model has rolled out the real thing.
      if (motion && !app.stage.content) app.stage.showModel(motion);
    },
    () => {
      // The stored motion is missing; the model rolls out its own when it has arrived.
    },
  );
}

/** Opens the Lab and waits for its engine. */
async function goToLab(): Promise<void> {
  app.settings.change(IN_LAB);
  while (app.engine.state === "loading")
    await new Promise<void>((changed) => {
      const stop = app.engine.on(() => {
        stop();
        changed();
      });
    });
}

listenToDrops(async (dropped, at) => {
  const { files, problems } = await dropped;
  if (!app.isLab) await goToLab();
  await openFiles(app, files, at);
  for (const problem of problems) app.notices.add({ kind: "error", ...problem, at });
});

/** English where the preferred language cannot be loaded. */
const words = app.words.loadPreferred().catch(() => app.words.load("en"));
void words.then(() => {
  document.querySelector("#boot")?.remove();
  render(html`<pg-doors .app=${app} .startLab=${startLab}></pg-doors>`, document.body);
});
