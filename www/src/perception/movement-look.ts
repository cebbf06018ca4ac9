// Plays a generated movement next to the natural one of its trial, to see whether it has failed.
import { html, nothing } from "lit";
import type { StudyTrial } from "../engine/whole-protocol";
import { eachFrame } from "../ui/browser";
import { icon } from "../ui/icons";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { View } from "../ui/view";
import { motionsOf, pairOf } from "./motions";
import { CanvasPair } from "./pair-stage";
import { perceptionWords } from "./view-words";
import type { PerceptionStore } from "./perception-store";
import "../ui/dialog.css";

export class MovementLook extends View {
  declare perception: PerceptionStore;
  declare notices: NoticesStore;
  #id = "";
  #end = () => {};

  protected override stores() {
    return [];
  }

  protected override arrived(): void {
    this.whenLeaving(() => this.#end());
  }

  async open(id: string): Promise<void> {
    const { study } = this.perception;
    const pair = study && pairOf(study.info, id);
    if (!study || !pair) return;
    try {
      const motionOf = motionsOf(study.info, await this.perception.movements());
      this.#id = id;
      this.requestUpdate();
      await this.updateComplete;
      this.querySelector("dialog")?.showModal();
      this.#play(new CanvasPair(study.info, motionOf), pair, study.info.seconds);
    } catch (problem) {
      this.notices.addError(perceptionWords().look.failed, messageOf(problem));
    }
  }

  #play(stage: CanvasPair, pair: StudyTrial, seconds: number): void {
    this.querySelector(".pair-scene")?.replaceChildren(stage.element);
    stage.take(pair);
    let now = 0;
    const draw = (since: number) => {
      now += since;
      stage.draw(now % seconds, () => {});
    };
    const stop = eachFrame(draw, Infinity);
    this.#end = () => {
      stop();
      stage.dispose();
      this.#end = () => {};
    };
  }

  protected override render() {
    const words = perceptionWords().look;
    return html`
      <dialog class="look" aria-label=${words.label} data-testid="look" @close=${() => this.#end()}>
        <div class="dialog-body stack">
          <header><h2>${this.#id || nothing}</h2>
            <form method="dialog"><button class="round" aria-label=${words.close}>${icon("close")}</button></form></header>
          <div class="pair-scene"></div>
          <p class="hint look-sides"><span>${words.natural}</span><span>${words.generated}</span></p>
        </div>
      </dialog>`;
  }
}
customElements.define("pg-perception-look", MovementLook);
