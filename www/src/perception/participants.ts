// The table of participations on this machine: continue, save or forget each.
import { html, nothing } from "lit";
import type { AnswersFile } from "../engine/whole-protocol";
import { download } from "../ui/download";
import { icon } from "../ui/icons";
import { csvFile, jsonFile } from "./answer-files";
import { answersOf, codeOf } from "./class-code";
import { answered, isComplete, type StoredParticipation } from "./participation";
import type { PerceptionStore } from "./perception-store";

const save = ({ name, text }: AnswersFile) =>
  download(
    name,
    new Blob([text], { type: name.endsWith(".csv") ? "text/csv;charset=utf-8" : "application/json" }),
  );

const COLUMNS = ["Participant", "Study", "Answered", ""];

function row(store: PerceptionStore, participation: StoredParticipation) {
  const { key, participant, title, trials, simulated, seed, study, rows } = participation;
  const done = answered(participation);
  const forget = () => {
    if (
      done === 0 ||
      confirm(
        `Forget the ${done} answers of ${participant}? They are on no other machine, unless you saved them.`,
      )
    )
      void store.forget(key);
  };
  const answers = isComplete(participation) ? answersOf(rows) : null;
  const code = answers && codeOf(study, { seed, simulated, answers });
  return html`
    <tr data-testid="participant" data-complete=${isComplete(participation)}>
      <th scope="row">${participant}${simulated ? html` <small>simulated</small>` : nothing}
        ${code ? html`<code class="class-code" data-testid="class-code" title="The answers in one code, for a class">${code}</code>` : nothing}</th>
      <td>${title}</td>
      <td>${done} of ${trials}</td>
      <td class="row-buttons">
        ${isComplete(participation) ? nothing : html`<button class="small" data-testid="resume" ?disabled=${store.busy} @click=${() => void store.resume(key)}>${icon("play")} Go on</button>`}
        <button class="small" data-testid="save-csv" ?disabled=${done === 0} aria-label="CSV of ${participant}" @click=${() => save(csvFile([participation]))}>CSV</button>
        <button class="small" data-testid="save-json" ?disabled=${done === 0} aria-label="JSON of ${participant}" @click=${() => save(jsonFile([participation]))}>JSON</button>
        <button class="round" aria-label="Forget ${participant}" title="Forget" @click=${forget}>${icon("close")}</button>
      </td>
    </tr>`;
}

export function participants(store: PerceptionStore) {
  const { participations, storageProblem } = store;
  const all = participations.filter((participation) => answered(participation) > 0);
  const warning = storageProblem
    ? html`<p class="bad" role="alert">This browser does not keep the answers (${storageProblem}): save them before you leave the page.</p>`
    : nothing;
  if (participations.length === 0)
    return html`${warning}<p class="empty">Nobody has answered on this machine yet. Answers appear here as they come, and stay when the tab is closed.</p>`;
  return html`
    ${warning}
    <div class="table-box" tabindex="0" role="region" aria-label="Participants">
      <table class="participants">
        <thead><tr>${COLUMNS.map((column) => html`<th scope="col">${column || html`<span class="visually-hidden">Files</span>`}</th>`)}</tr></thead>
        <tbody>${participations.map((participation) => row(store, participation))}</tbody>
      </table>
    </div>
    ${
      all.length > 1
        ? html`<div class="files">
            <button class="small" data-testid="save-all-csv" @click=${() => save(csvFile(all))}>${icon("save")} All as one CSV</button>
            <button class="small" data-testid="save-all-json" @click=${() => save(jsonFile(all))}>${icon("save")} All as one JSON</button>
          </div>`
        : nothing
    }`;
}
