// The question what becomes of work that is not saved. Loaded when it is first asked.
import { html, render } from "lit";
import "./dialog.css";

/** What the visitor wants done with work that has to make place. */
export type Answer = "save" | "discard" | "keep";

/** Asks in a dialog; whoever only closes it keeps what there is. The focus goes back to where it was. */
export function askInDialog(what: readonly string[]): Promise<Answer> {
  const dialog = document.createElement("dialog");
  dialog.dataset.testid = "unsaved";
  dialog.setAttribute("aria-labelledby", "unsaved-title");
  dialog.setAttribute("aria-describedby", "unsaved-words");
  const [it, its] = what.length === 1 ? ["it", "its"] : ["them", "their"];
  render(
    html`
    <form method="dialog" class="dialog-body">
      <h2 id="unsaved-title">Save ${it} first?</h2>
      <p id="unsaved-words">Not saved: ${what.join(", and ")}. What comes now takes ${its} place.</p>
      <div class="button-row">
        <button class="small primary" value="save" data-testid="unsaved-save">Save ${it} first</button>
        <button class="small" value="discard" data-testid="unsaved-discard">Discard</button>
        <button class="small" value="keep" data-testid="unsaved-keep">Keep ${it}</button>
      </div>
    </form>`,
    dialog,
  );
  document.body.append(dialog);
  dialog.showModal();
  return new Promise((resolve) => {
    dialog.addEventListener("close", () => {
      dialog.remove();
      const { returnValue } = dialog;
      resolve(returnValue === "save" || returnValue === "discard" ? returnValue : "keep");
    });
  });
}
