// The table of participations on this machine: continue, save or forget each.
import { html, nothing } from "lit";
import type { AnswersFile } from "../engine/whole-protocol";
import { download } from "../ui/download";
import { icon } from "../ui/icons";
import { csvFile, jsonFile } from "./answer-files";
import { answersOf, codeOf } from "./class-code";
import { answered, isComplete, type StoredParticipation } from "./participation";
import { perceptionWords } from "../words/perception";
import type { PerceptionStore } from "./perception-store";

const save = ({ name, text }: AnswersFile) =>
  download(
    name,
    new Blob([text], { type: name.endsWith(".csv") ? "text/csv;charset=utf-8" : "application/json" }),
  );

function row(store: PerceptionStore, participation: StoredParticipation) {
  const { key, participant, title, trials, simulated, seed, study, rows } = participation;
  const done = answered(participation);
  const { participants: words, run } = perceptionWords();
  const forget = () => {
    if (done === 0 || confirm(words.sureToForget(done, participant))) void store.forget(key);
  };
  const answers = isComplete(participation) ? answersOf(rows) : null;
  const code = answers && codeOf(study, { seed, simulated, answers });
  return html`
    <tr data-testid="participant" data-complete=${isComplete(participation)}>
      <th scope="row">${participant}${simulated ? html` <small>${words.simulated}</small>` : nothing}
        ${code ? html`<code class="class-code" data-testid="class-code" title=${words.classCode}>${code}</code>` : nothing}</th>
      <td>${title}</td>
      <td>${run.of(done, trials)}</td>
      <td class="row-buttons">
        ${isComplete(participation) ? nothing : html`<button class="small" data-testid="resume" ?disabled=${store.busy} @click=${() => void store.resume(key)}>${icon("play")} ${words.goOn}</button>`}
        <button class="small" data-testid="save-csv" ?disabled=${done === 0} aria-label=${words.csv(participant)} @click=${() => save(csvFile([participation]))}>CSV</button>
        <button class="small" data-testid="save-json" ?disabled=${done === 0} aria-label=${words.json(participant)} @click=${() => save(jsonFile([participation]))}>JSON</button>
        <button class="round" aria-label=${words.forgetOf(participant)} title=${words.forget} @click=${forget}>${icon("close")}</button>
      </td>
    </tr>`;
}

export function participants(store: PerceptionStore) {
  const { participations, storageProblem } = store;
  const words = perceptionWords().participants;
  const all = participations.filter((participation) => answered(participation) > 0);
  const warning = storageProblem
    ? html`<p class="bad" role="alert">${words.notKept(storageProblem)}</p>`
    : nothing;
  if (participations.length === 0) return html`${warning}<p class="empty">${words.nobody}</p>`;
  return html`
    ${warning}
    <div class="table-box" tabindex="0" role="region" aria-label=${words.label}>
      <table class="participants">
        <thead><tr>${words.heads.map((column) => html`<th scope="col">${column}</th>`)}<th scope="col"><span class="visually-hidden">${words.files}</span></th></tr></thead>
        <tbody>${participations.map((participation) => row(store, participation))}</tbody>
      </table>
    </div>
    ${
      all.length > 1
        ? html`<div class="files">
            <button class="small" data-testid="save-all-csv" @click=${() => save(csvFile(all))}>${icon("save")} ${words.allCsv}</button>
            <button class="small" data-testid="save-all-json" @click=${() => save(jsonFile(all))}>${icon("save")} ${words.allJson}</button>
          </div>`
        : nothing
    }`;
}
