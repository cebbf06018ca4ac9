// Work of the visitor that is on no disk: the visitor is asked before something else takes its place.
import { lab } from "../words/lab";

export interface Work {
  /** "the model that was trained here" */
  what: string;
  /** Puts it on the visitor's disk. */
  save(): unknown;
}

/**
 * Whether something may take the place of these works. Asks when there are any, and first saves them if the
 * visitor wants that.
 */
export async function mayLose(...works: readonly (Work | null)[]): Promise<boolean> {
  const unsaved = works.filter((work) => work !== null);
  if (unsaved.length === 0) return true;
  const answer = await askAbout(unsaved.map(({ what }) => what));
  if (answer === "save") for (const { save } of unsaved) await save();
  return answer === "save" || answer === "discard";
}

async function askAbout(works: readonly string[]): Promise<"save" | "discard" | "keep" | null> {
  const words = lab().files.unsaved;
  const text = words.text(works);
  try {
    const { choose } = await import("./choice-dialog");
    return await choose({
      testId: "unsaved",
      title: words.title(works.length),
      text: `${text} ${words.takesPlace(works.length)}`,
      answers: [
        ["save", words.save(works.length)],
        ["discard", words.discard],
        ["keep", words.keep(works.length)],
      ],
    });
  } catch {
    // Without a network the dialog may not load; the browser's own asks the same in short.
    return confirm(`${text} ${words.discard}?`) ? "discard" : "keep";
  }
}

/** Asks before an action that cannot be undone. */
export async function isConfirmed(title: string, text: string, action: string): Promise<boolean> {
  try {
    const { choose } = await import("./choice-dialog");
    const answers = [["yes", action] as const, ["no", lab().files.unsaved.notNow] as const];
    return (await choose({ testId: "confirm", title, text, answers })) === "yes";
  } catch {
    return confirm(`${title} ${text}`);
  }
}
