// Starts the page: the stores, the views, the first motion and the engine.
import "./ui/base.css";
import "./ui/controls.css";
import "./app/layout.css";
import { html, render } from "lit";
import { App } from "./app/app";
import { listenToDrops } from "./app/dropping";
import { fetchStartModel, fetchStartMotion } from "./app/start-files";
import { listenToKeys } from "./app/keyboard";
import { openFiles } from "./app/open-files";
import "./app/page";
import type { PageView } from "./app/page";
import { wouldLose } from "./app/leaving";
import { startEngine } from "./engine/engine";
import { browserAddressBar } from "./settings/address";
import { isEmbedded } from "./settings/settings";
import { whenIdle } from "./ui/idle";

const app = new App(browserAddressBar, isEmbedded(location.search));
const root = document.documentElement;
const showState = () => {
  root.dataset.engine = app.engine.state;
};
showState();
app.engine.on(showState);
const showType = () => root.toggleAttribute("data-large", app.embedded || app.settings.values.large);
showType();
app.settings.on(showType);
if (!matchMedia("(prefers-reduced-motion: reduce)").matches) app.playback.play();

document.querySelector("#boot")?.remove();
render(html`<pg-page .app=${app}></pg-page>`, document.body);
const page = document.querySelector<PageView>("pg-page");

listenToKeys({
  togglePlay: () => page?.clock?.togglePlay(),
  step: (direction) => page?.clock?.step(direction),
  resetCouplings: () => app.isPlayView && app.model.couplings.resetAll(),
  help: () => page?.openHelp(),
  hold: (held) => page?.holdByKey(held),
  projector: () => app.settings.change({ large: !app.settings.values.large }),
});
listenToDrops(async (dropped, at) => {
  const { files, problems } = await dropped;
  await openFiles(app, files, at);
  for (const problem of problems) app.notices.add({ kind: "error", ...problem, at });
});
addEventListener("hashchange", () => app.followAddress());
// The browser asks whether to leave.
addEventListener("beforeunload", (event) => wouldLose(app) && event.preventDefault());

const start = () => app.start(startEngine, fetchStartModel());
// A load that failed may work now.
addEventListener("online", () => void (app.engine.state === "failed" && start()));
void start().then(() => {
  // A browser that stores nothing is no reason for a notice to a visitor with nothing to store.
  if (!app.embedded && app.engine.state === "ready")
    whenIdle(() => {
      app.session.get().then(
        (session) => {
          if (page) page.session = session;
        },
        () => {},
      );
    });
  if (import.meta.env.PROD && "serviceWorker" in navigator)
    whenIdle(
      () => void app.offline.begin(async () => (await import("./offline/service-workers")).serviceWorkers()),
    );
});
fetchStartMotion().then(
  (motion) => {
    // Until the model has rolled out the real thing.
    if (motion && !app.stage.content) app.stage.showModel(motion);
  },
  () => {
    // The stored motion is missing; the model rolls out its own when it has arrived.
  },
);
