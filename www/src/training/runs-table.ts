// The table of this visit's trainings: their differences, their progress, and the one on the stage.
import { html, nothing } from "lit";
import { duration, grouped, sentence } from "../ui/format";
import { icon } from "../ui/icons";
import "../terms/term";
import { View } from "../ui/view";
import { bestBound, bestRun, type Column, dataOf, differences, endOfMotion, type Run } from "./runs";
import "./runs-table.css";
import type { TrainingStore } from "./training-store";
import { lab } from "../words/lab";

export class RunsView extends View {
  declare training: TrainingStore;

  #state(run: Run) {
    const { state, settings, steps, ending } = run;
    const last = steps.at(-1);
    const words = lab().learn.runs;
    return state === "running"
      ? html`<progress max="1" .value=${last?.fraction ?? 0} aria-label=${words.progress(settings.seed)} title=${last ? lab().learn.phases[last.phase] : lab().learn.training.settingUp}></progress>`
      : html`<span class=${state === "failed" ? "bad" : ""} title=${ending}>${[words.state[state], endOfMotion(run)].filter(Boolean).join(", ")}</span>`;
  }

  #row(run: Run, columns: readonly Column[], best: boolean) {
    const { training } = this;
    const words = lab().learn.runs;
    const { settings, state, steps, elapsed, ending } = run;
    const { seed } = settings;
    const chosen = training.chosen === run;
    const open = run.model !== null || state === "running";
    const choose = () => void training.choose(run);
    return html`
      <tr class=${chosen ? "chosen" : ""} data-state=${state} data-testid="run" @click=${(event: Event) => {
        if (open && !chosen && !(event.target as Element).closest("label, button")) choose();
      }}>
        <th scope="row"><label title=${words.takeUp}>
          <input type="radio" name="run" aria-label=${words.show(seed)} .checked=${chosen} ?disabled=${!open} @change=${choose} />${seed}</label></th>
        ${columns.map((column) => html`<td class="differs" title=${column.key(run)}>${column.text(run)}</td>`)}
        <td class=${best ? "best" : ""}>${steps.length > 0 ? grouped(bestBound(run)) : ""}${best ? html`<span class="visually-hidden">, ${words.best}</span>` : nothing}</td>
        <td>${steps.at(-1)?.iteration ?? ""}</td>
        <td>${elapsed === 0 ? "" : elapsed < 10 ? lab().learn.clips.seconds(elapsed) : duration(elapsed)}</td>
        <td class="state">${this.#state(run)}</td>
        <td>${
          training.canRemove(run)
            ? html`<button class="round" aria-label=${words.remove(seed)} title=${lab().learn.clips.remove} @click=${() => training.remove(run)}>${icon("close")}</button>`
            : nothing
        }</td>
      </tr>
      ${state === "failed" ? html`<tr class="why"><td colspan=${6 + columns.length} class="bad">${sentence(ending)}</td></tr>` : nothing}`;
  }

  protected override render() {
    const { training } = this;
    const { runs, charted } = training;
    if (!charted) return nothing;
    const { runs: words, settings } = lab().learn;
    const columns = differences(runs);
    const data = dataOf(charted);
    const alike = runs.filter((run) => dataOf(run) === data);
    const best = alike.length > 1 ? bestRun(alike.filter(({ model }) => model !== null)) : null;
    return html`
      <header class="panel-head row">
        <h3>${words.title}</h3>
        <button class="small" data-testid="clear-runs" ?disabled=${!runs.some((run) => training.canRemove(run))} @click=${() => training.clear()}>${words.clear}</button>
      </header>
      <div class="table-box" tabindex="0" role="region" aria-label=${words.title}>
        <table class="note tabular" data-testid="runs">
          <thead><tr>
            <th scope="col"><pg-term of="seed" text=${settings.seed}></pg-term></th>
            ${columns.map(({ head, meaning, term }) => html`<th scope="col" title=${meaning} aria-label=${meaning}>${term ? html`<pg-term of=${term} text=${head}></pg-term>` : head}</th>`)}
            <th scope="col"><pg-term of="bound" text=${words.bound}></pg-term></th><th scope="col" title=${words.iterations}><pg-term of="iterations" text=${words.iterationsHead}></pg-term></th><th scope="col">${words.time}</th><td></td><td></td>
          </tr></thead>
          <tbody>${runs.map((run) => this.#row(run, columns, run === best))}</tbody>
        </table>
      </div>
      ${alike.length < runs.length ? html`<p class="hint">${words.comparable}</p>` : nothing}`;
  }
}
customElements.define("pg-runs", RunsView);
