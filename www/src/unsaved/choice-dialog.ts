// A question with a few answers, in a dialog. Loaded when it is first asked.
import { html, render } from "lit";
import "../ui/dialog.css";

export interface Choice<Answer extends string> {
  /** Of the dialog, and the beginning of those of the answers. */
  testId: string;
  title: string;
  text: string;
  /** The first is the one that most visitors want. */
  answers: readonly (readonly [answer: Answer, label: string])[];
}

/** Asks; null: the visitor has only closed the dialog. The focus goes back to where it was. */
export function choose<Answer extends string>(choice: Choice<Answer>): Promise<Answer | null> {
  const { testId, title, text, answers } = choice;
  const dialog = document.createElement("dialog");
  dialog.dataset.testid = testId;
  dialog.setAttribute("aria-labelledby", `${testId}-title`);
  dialog.setAttribute("aria-describedby", `${testId}-text`);
  render(
    html`
    <form method="dialog" class="dialog-body stack">
      <h2 id="${testId}-title">${title}</h2>
      <p id="${testId}-text">${text}</p>
      <div>
        ${answers.map(
          ([answer, label], place) =>
            html`<button class="small ${place === 0 ? "primary" : ""}" value=${answer} data-testid="${testId}-${answer}">${label}</button>`,
        )}
      </div>
    </form>`,
    dialog,
  );
  document.body.append(dialog);
  dialog.showModal();
  return new Promise((resolve) => {
    dialog.addEventListener("close", () => {
      dialog.remove();
      resolve(answers.find(([answer]) => answer === dialog.returnValue)?.[0] ?? null);
    });
  });
}
