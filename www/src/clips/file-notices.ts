// What was unusual about a file, folded away below its row.
import { html, nothing } from "lit";
import "./clips.css";
import { lab } from "../words/lab";

export const fileNotices = (warnings: readonly string[]) =>
  warnings.length === 0
    ? nothing
    : html`<details class="warnings"><summary>${lab().learn.clips.notices(warnings.length)}</summary>
        <ul>${warnings.map((warning) => html`<li>${warning}</li>`)}</ul></details>`;
