// Changing settings, and keeping the URL in step with them.
import type { App } from "../app";
import { type SettingName, type Settings, withinLimits, writeSettings } from "../state";

let writing = 0;

/** Changes settings, each within its limits; what is no value is left as it was. */
export function changeSettings(app: App, change: Partial<Settings>): void {
  const next = { ...app.settings };
  for (const name of Object.keys(change) as SettingName[]) {
    const value = withinLimits(name, change[name] as never);
    if (value !== null) Object.assign(next, { [name]: value });
  }
  app.settings = next;
  app.player.speed = next.speed;
  app.player.loops = next.loop;
  // Browsers allow only so many history writes a second; a slider makes more.
  clearTimeout(writing);
  writing = window.setTimeout(() => {
    const fragment = writeSettings(app.settings);
    const url = `${location.pathname}${location.search}${fragment ? `#${fragment}` : ""}`;
    history.replaceState(history.state, "", url);
  }, 250);
  app.tell("settings", "playback");
}
