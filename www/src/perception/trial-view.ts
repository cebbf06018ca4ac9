// The display of a trial: the cross, the movements, and the question with a button for each side.
import { perceptionWords } from "./view-words";

export const SIDES = ["left", "right"] as const;
export type Side = (typeof SIDES)[number];

/** What is visible now. Invisible elements keep their places, so that nothing jumps. */
type Showing = "cross" | "movement" | "question";

export interface TrialView {
  readonly root: HTMLElement;
  show(what: Showing): void;
  /** Calls back when a side is tapped or clicked: its button, or its half of the movements. */
  answered(by: (side: Side) => void): void;
}

const made = (name: string, className: string, text = "") =>
  Object.assign(document.createElement(name), { className, textContent: text });

/** Draws a trial into the display. All trials share one stage. */
export function trialView(display: HTMLElement, stage: HTMLElement, question: string): TrialView {
  const root = made("div", "pair-trial");
  root.dataset.testid = "pair-trial";
  const cross = made("div", "fixation", "+");
  cross.setAttribute("aria-hidden", "true");
  const scene = made("div", "pair-scene");
  scene.append(stage, cross);
  // Screen readers read the question when its text appears.
  const asked = made("p", "pair-question");
  asked.setAttribute("role", "status");
  const buttons = SIDES.map((side) => {
    const button = made("button", "primary big", perceptionWords().run[side]) as HTMLButtonElement;
    button.type = "button";
    button.dataset.testid = `answer-${side}`;
    return button;
  });
  const answers = made("div", "pair-answers");
  answers.append(...buttons);
  root.append(scene, asked, answers);
  let showing: Showing | null = null;
  const show = (what: Showing) => {
    if (what === showing) return;
    showing = what;
    root.dataset.phase = what;
    asked.textContent = what === "question" ? question : "";
    for (const button of buttons) button.disabled = what !== "question";
  };
  show("cross");
  display.replaceChildren(root);
  return {
    root,
    show,
    answered(by) {
      buttons.forEach((button, i) => button.addEventListener("click", () => by(SIDES[i]!)));
      scene.addEventListener("click", (event) => {
        const { left, width } = scene.getBoundingClientRect();
        by(event.clientX < left + width / 2 ? "left" : "right");
      });
    },
  };
}
