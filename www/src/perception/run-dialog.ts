// The experiment over the whole page: jsPsych's display, the progress and a button to leave.
import { html } from "lit";
import { icon } from "../ui/icons";
import type { NoticesStore } from "../ui/notices-store";
import { View } from "../ui/view";
import { motionsOf } from "./motions";
import { CanvasPair } from "./pair-stage";
import type { PerceptionStore, ActiveParticipation } from "./perception-store";
import { answered } from "./participation";
import { run, type Running } from "./run";
import { messageOf } from "../ui/format";
import { perceptionWords } from "./view-words";
import "../ui/dialog.css";
import "./run-dialog.css";

export class RunDialog extends View {
  declare perception: PerceptionStore;
  declare notices: NoticesStore;
  #running: Running | null = null;

  protected override arrived(): void {
    this.whenLeaving(() => this.#running?.leave());
  }

  protected override updated(): void {
    const { active } = this.perception;
    if (active && !this.#running) this.#begin(active);
  }

  #begin(active: ActiveParticipation): void {
    const { perception } = this;
    const dialog = this.querySelector("dialog");
    const display = document.createElement("div");
    display.className = "run-display";
    dialog?.querySelector(".run-place")?.replaceChildren(display);
    let stage: CanvasPair;
    try {
      stage = new CanvasPair(active.study, motionsOf(active.study, active.movements));
    } catch {
      const { notShown, noGraphics } = perceptionWords().run;
      this.notices.addError(notShown, noGraphics);
      perception.leave();
      return;
    }
    dialog?.showModal();
    const { study, steps, columns, participation } = active;
    this.#running = run(display, stage, {
      ...{ study, steps, columns },
      simulated: participation.simulated,
      keep: (row) => perception.addRow(row),
      begins: () => display.focus({ preventScroll: true }),
    });
    this.#running.over
      .catch((problem) => this.notices.addError(perceptionWords().run.stopped, messageOf(problem)))
      .finally(() => {
        this.#running = null;
        stage.dispose();
        display.remove();
        dialog?.close();
        perception.leave();
      });
  }

  #leave(): void {
    this.#running?.leave();
  }

  protected override render() {
    const { participation } = this.perception.active ?? {};
    const [done, all] = participation ? [answered(participation), participation.trials] : [0, 1];
    const { run: words, setup } = perceptionWords();
    return html`
      <dialog class="run" aria-label=${setup} data-testid="run" @cancel=${(event: Event) => {
        event.preventDefault();
        this.#leave();
      }}>
        <header class="row">
          <progress max=${all} .value=${done} aria-label=${words.progress}></progress>
          <span class="hint tabular" data-testid="run-progress">${words.of(done, all)}</span>
          <button class="small" data-testid="run-leave" title=${words.leaveMeaning} @click=${() => this.#leave()}>${icon("close")} ${words.leave}</button>
        </header>
        <div class="run-place"></div>
      </dialog>`;
  }
}
customElements.define("pg-perception-run", RunDialog);
