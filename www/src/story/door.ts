// Where the page opens: at the address, or, without one, where the visitor was: in a chapter or in the Lab.
import type { SettingsStore } from "../settings/settings-store";
import { keep, kept } from "../ui/kept";

/** The name under which the browser keeps the open chapter, or "lab". */
const KEPT = "door";
const LAB = "lab";

/** A page in a frame of another page opens in the Lab, and keeps nothing. */
export function openDoor(settings: SettingsStore, embedded: boolean): void {
  if (embedded) return;
  const last = kept(KEPT);
  if (settings.address.fragment.replace(/^#/, "") === "" && last !== LAB)
    settings.takeFragment(`story=${Number.parseInt(last ?? "", 10) || 1}`);
  let before = settings.values.chapter;
  settings.on(() => {
    const { chapter } = settings.values;
    if (chapter !== before) keep(KEPT, chapter > 0 ? String(chapter) : LAB);
    before = chapter;
  });
}
