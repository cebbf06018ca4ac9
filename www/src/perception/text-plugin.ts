// jsPsych's plugin for a page of text with a button: consent, instructions, a pause, thanks.
import { type JsPsych, type JsPsychPlugin, ParameterType, type TrialType } from "jspsych";
import { perceptionWords } from "./view-words";
import type { TextStep } from "./steps";

const info = {
  name: "vcgpdm-text",
  version: "1.0.0",
  parameters: {
    /** The text, and when the button works. */
    text: { type: ParameterType.OBJECT, default: undefined },
  },
  data: {
    /** "consent", "instructions", "pause" or "end". */
    page: { type: ParameterType.STRING },
    /** Milliseconds until the participant pressed the button. */
    rt: { type: ParameterType.FLOAT },
  },
  citations: {},
} as const;

type Info = typeof info;

/** Seconds between two updates of the remaining time. */
const SECOND = 1000;

export class TextPlugin implements JsPsychPlugin<Info> {
  static readonly info = info;

  constructor(private readonly jsPsych: JsPsych) {}

  trial(display: HTMLElement, { text }: TrialType<Info>, loaded?: () => void) {
    return this.#run(display, text as TextStep, loaded, () => {});
  }

  simulate(
    { text }: TrialType<Info>,
    mode: "visual" | "data-only",
    _options: unknown,
    loaded?: () => void,
  ): Promise<object> {
    const { page } = text as TextStep;
    if (mode === "visual") {
      return this.#run(this.jsPsych.getDisplayElement(), text as TextStep, loaded, (button) =>
        this.jsPsych.pluginAPI.clickTarget(button, 1),
      );
    }
    loaded?.();
    return Promise.resolve({ page, rt: 0 });
  }

  /** Calls `open` when the button works. */
  #run(
    display: HTMLElement,
    { page, paragraphs, onward, wait }: TextStep,
    loaded: (() => void) | undefined,
    open: (button: HTMLButtonElement) => void,
  ) {
    const since = performance.now();
    const root = document.createElement("div");
    root.className = "text-page";
    root.dataset.testid = `page-${page}`;
    root.append(
      ...paragraphs.map((text) => Object.assign(document.createElement("p"), { textContent: text })),
    );
    const button = Object.assign(document.createElement("button"), {
      type: "button",
      className: "primary big",
    });
    button.dataset.testid = "onward";
    const left = Object.assign(document.createElement("p"), { className: "hint" });
    root.append(button, left);
    display.replaceChildren(root);
    const count = () => {
      if (!root.isConnected) return;
      const rest = Math.ceil(wait - (performance.now() - since) / 1000);
      button.disabled = rest > 0;
      button.textContent = onward;
      left.textContent = rest > 0 ? perceptionWords().run.wait(rest) : "";
      if (rest > 0) return void this.jsPsych.pluginAPI.setTimeout(count, Math.min(SECOND, SECOND * rest));
      button.focus({ preventScroll: true });
      open(button);
    };
    count();
    loaded?.();
    return new Promise<object>((end) => {
      button.addEventListener("click", () => end({ page, rt: Math.round(performance.now() - since) }));
    });
  }
}
