// What was made here and is on no disk: the visitor is asked before something else takes its place.
import type { Answer } from "./unsaved-dialog";

export interface Work {
  /** "the model that was trained here" */
  what: string;
  /** Puts it on the visitor's disk. */
  save(): unknown;
}

/**
 * Whether something may take the place of these; asks where there is any, and first saves what the visitor
 * wants saved.
 */
export async function mayLose(...works: readonly (Work | null)[]): Promise<boolean> {
  const lost = works.filter((work) => work !== null);
  if (lost.length === 0) return true;
  const answer = await ask(lost.map(({ what }) => what));
  if (answer === "save") for (const { save } of lost) await save();
  return answer !== "keep";
}

async function ask(what: readonly string[]): Promise<Answer> {
  try {
    const { askInDialog } = await import("./unsaved-dialog");
    return await askInDialog(what);
  } catch {
    // Without a network the dialog may not come; the browser's own says the same in short.
    return confirm(`Not saved: ${what.join(", and ")}. Discard?`) ? "discard" : "keep";
  }
}
