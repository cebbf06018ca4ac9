// Changing settings, and keeping the URL in step with them.
import type { App } from "../app/app";
import { type SettingName, type Settings, withinLimits, writeSettings } from "./settings";

/** Browsers allow only so many history writes a second; a slider makes more. */
const BETWEEN_WRITES = 300;
let timer = 0;
let written = -Infinity;

function writeUrl(app: App): void {
  clearTimeout(timer);
  const wait = written + BETWEEN_WRITES - performance.now();
  if (wait > 0) {
    timer = window.setTimeout(() => writeUrl(app), wait);
    return;
  }
  written = performance.now();
  const fragment = writeSettings(app.settings);
  history.replaceState(history.state, "", `${location.pathname}${location.search}${fragment ? `#${fragment}` : ""}`);
}

/** Changes settings, each within its limits; what is no value is left as it was. */
export function changeSettings(app: App, change: Partial<Settings>): void {
  const next = { ...app.settings };
  for (const name of Object.keys(change) as SettingName[]) {
    const value = withinLimits(name, change[name] as never);
    if (value !== null) Object.assign(next, { [name]: value });
  }
  // Another view is another page to whoever presses Back.
  if (next.view !== app.settings.view) history.pushState(null, "");
  app.settings = next;
  app.player.speed = next.speed;
  app.player.loops = next.loop;
  writeUrl(app);
  app.tell("settings", "playback");
}
