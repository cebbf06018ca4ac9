// Where the page opens: at the address, or, without one, where the visitor was: in a chapter or in the Lab.
import { keep, kept } from "../ui/browser";
import type { SettingsStore } from "./settings-store";

/** The names under which the browser keeps the last chapter, and "lab" for a visitor who has left the story. */
const [CHAPTER, DOOR] = ["chapter", "door"];
const LAB = "lab";

/** The chapter where the visitor was last. */
export const lastChapter = (): number => Number.parseInt(kept(CHAPTER) ?? "", 10) || 1;

/** A page in a frame of another page opens in the Lab, and keeps nothing. */
export function openDoor(settings: SettingsStore, embedded: boolean): void {
  if (embedded) return;
  if (settings.address.fragment.replace(/^#/, "") === "" && kept(DOOR) !== LAB)
    settings.takeFragment(`story=${lastChapter()}`);
  let before = settings.values.chapter;
  settings.on(() => {
    const { chapter, teach } = settings.values;
    if (chapter === before || teach) return;
    keep(DOOR, chapter > 0 ? "story" : LAB);
    if (chapter > 0) keep(CHAPTER, String(chapter));
    before = chapter;
  });
}
