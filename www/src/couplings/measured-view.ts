// The measures of the motion under the couplings now.
import { html, nothing } from "lit";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import type { BodyStore } from "./body-store";
import { measuresText } from "./measures-text";
import "./measured-view.css";
import type { ModelStore } from "./model-store";
import type { ReadingsStore } from "./readings-store";
import { lab, shownPart } from "../words/lab";

export class MeasuredView extends View {
  declare model: ModelStore;
  declare body: BodyStore;
  declare readings: ReadingsStore;

  protected override stores() {
    return [this.model, this.body, this.readings];
  }

  protected override render() {
    const { reports, isCurrent } = this.body;
    if (!reports) return nothing;
    const names = (this.model.model?.info.parts ?? []).map(({ name }) => shownPart(name));
    const { parts, step, trouble } = measuresText(reports.now, reports.learned, names);
    const which = this.readings.bothShown ? lab().readings.text[reports.now.request.reading] : "";
    const end = [
      step && html`<span data-testid="measured-step">${step}</span>`,
      trouble && html`<strong class="bad" data-testid="measured-trouble">${trouble}</strong>`,
    ];
    return html`
      <p class="measured" role="status" data-testid="measured" data-current=${isCurrent ? "yes" : "no"}>
        <span>${lab().measured.compared(which)}</span>
        ${parts.map(
          ({ part, words }) => html`
          <span class="limbs" data-testid="measured-${part}" style=${partStyle(partColour(part))}><i class="swatch"></i>${names[part]} ${words}</span>`,
        )}
        ${end}
      </p>`;
  }
}
customElements.define("pg-measured", MeasuredView);
