// The dialog "Share": the link of a state of the page, with the model in it or without, its QR code, and the
// line for a frame in another page.
import { html, nothing, render } from "lit";
import type { App } from "./app";
import { saveFile } from "./save-file";
import { addressOf as addressOfFile } from "../links/model-file";
import { packed } from "../links/packed-model";
import { LinkError, type LinkProblem } from "../links/problem";
import { DARES } from "../settings/settings";
import "../ui/dialog.css";
import { messageOf } from "../ui/format";
import { icon } from "../ui/icons";
import { linkWords, loadLinks, loadTeach, teachWords } from "../words/sections";
import { addressOf, codeOf, frameLine, LONGEST_CODE } from "./code";
import "./code.css";

/** Hosts that no other machine can reach. */
const LOCAL = /^(localhost|127\.|\[::1\]|$)/;
/** Characters of a link that are shown. */
const SHOWN = 120;

/** The code as a picture, dark on white. */
export function codePicture(address: string, label: string) {
  const { side, path } = codeOf(address);
  return html`<svg class="code-picture" role="img" aria-label=${label} viewBox="0 0 ${side} ${side}" shape-rendering="crispEdges"><path d=${path}></path></svg>`;
}

/** Null: the page can open a file of this name. */
function problemOfName(file: string): LinkProblem | null {
  try {
    addressOfFile(file, document.baseURI);
    return null;
  } catch (thrown) {
    if (thrown instanceof LinkError) return thrown.problem;
    throw thrown;
  }
}

const shortened = (address: string) => (address.length > SHOWN ? `${address.slice(0, SHOWN)}…` : address);

/** `fragment`: the state without a model in it. */
export async function showCode(app: App, fragment: string): Promise<void> {
  if (document.querySelector(".code-dialog")) return;
  const stage = app.isPlayView ? await import("./stage-model") : null;
  await Promise.all([loadTeach(app.words), loadLinks(app.words)]);
  const { code, exercises } = teachWords();
  const words = linkWords();
  const dialog = document.createElement("dialog");
  dialog.className = "code-dialog";
  dialog.setAttribute("aria-labelledby", "code-title");
  dialog.dataset.testid = "code";

  const model = stage?.modelOnStage(app) ?? null;
  /** The name of the model's file on the page's host. */
  let file = model?.name ?? "";
  /** Why no link with the model can be made. */
  let problem = "";
  let withModel = false;
  /** The number of the dare, 0 without one, and the line of the sender. */
  let [dare, line] = [0, ""];
  const parts = app.model.model?.info.parts.map(({ name }) => name).join() ?? "";
  const offered =
    app.isPlayView && app.stage.clip === null && parts === "lower,upper"
      ? (["pose", "pace"] as const)
      : /(^|&)hand=01\./.test(fragment)
        ? (["hand"] as const)
        : [];
  /** The fragment with the model in it; null: it is not made yet. */
  let carrying: string | null = null;

  async function carryModel(on: boolean): Promise<void> {
    withModel = on;
    draw();
    if (!on || !model || carrying !== null) return;
    try {
      carrying = app.fragmentWith({ packedModel: await packed(await model.content()) });
    } catch (thrown) {
      const long = thrown instanceof LinkError && thrown.problem.what === "long" ? thrown.problem : null;
      problem = long ? words.tooLong(long.most, long.found) : messageOf(thrown);
    }
    draw();
  }

  const copy = (text: string) => async (event: Event) => {
    const button = event.currentTarget as HTMLButtonElement;
    const said = await navigator.clipboard?.writeText(text).then(
      () => code.copied,
      () => code.notCopied,
    );
    button.textContent = said ?? code.notCopied;
  };

  /** A link with a dare begins with the couplings as learned; one arrow stops the arms only in this reading. */
  function dared(fragment: string): string {
    if (dare === 0) return fragment;
    const given = new URLSearchParams(fragment);
    given.delete("alpha");
    given.set("exercise", String(dare));
    if (dare === DARES.pose) given.set("reading", "learned");
    if (line) given.set("says", line);
    return given.toString();
  }

  const dares = () => html`
    <div class="code-dare"><label>${exercises.dares.title}
      <select data-testid="dare" @change=${({ target }: Event) => {
        dare = Number((target as HTMLSelectElement).value);
        draw();
      }}>
        <option value="0">${exercises.dares.none}</option>
        ${offered.map((name) => html`<option value=${DARES[name]}>${exercises.dares.tasks[name]}</option>`)}
      </select></label>
      ${
        dare > 0 && dare !== DARES.hand
          ? html`<input type="text" data-testid="dare-line" maxlength="80" aria-label=${exercises.dares.line} placeholder=${exercises.dares.line}
            @input=${({ target }: Event) => {
              line = (target as HTMLInputElement).value;
              draw();
            }} />`
          : nothing
      }</div>`;

  const choice = () => html`
    <label class="check"><input type="checkbox" data-testid="with-model" .checked=${withModel}
      @change=${({ target }: Event) => void carryModel((target as HTMLInputElement).checked)} />
      <span>${words.withModel} <small class="own-line">${words.withModelMeaning}</small></span></label>`;

  /** An address that opens and can be copied. */
  const link = (address: string, testId: string) => html`
    <p class="code-address note"><a href=${address} data-testid=${testId} @click=${() => dialog.close()}>${shortened(address)}</a></p>
    <div><button class="small" data-testid="copy-${testId}" @click=${copy(address)}>${code.copy}</button></div>`;

  /** The link of a file, short enough for a code, in place of a long link. */
  function shortLink() {
    const { short } = words;
    const address = addressOf(app.fragmentWith({ modelFile: file }));
    const wrong = problemOfName(file);
    return html`
      <section class="code-short stack loose" aria-labelledby="code-short">
        <h3 id="code-short">${short.title}</h3>
        <p>${short.how}</p>
        <label class="row wrap"><span>${short.file}</span>
          <input data-testid="model-file" spellcheck="false" .value=${file} aria-invalid=${wrong ? "true" : "false"} @input=${rename} />
          <button class="small" data-testid="save-short" ?disabled=${wrong !== null} @click=${saveModel}>${icon("save")} ${short.save}</button></label>
        ${
          wrong
            ? html`<p role="alert">${linkWords().problems(wrong)}</p>`
            : html`${codePicture(address, exercises.code)} ${link(address, "short-address")}`
        }
      </section>`;
  }

  function rename({ target }: Event): void {
    file = (target as HTMLInputElement).value.trim();
    draw();
  }

  function saveModel(): void {
    // Without the folders of its address.
    if (model) void saveFile(app, { ...model, name: file.split("/").at(-1) ?? file });
  }

  function state(fragment: string) {
    const address = addressOf(fragment);
    const line = frameLine(addressOf(fragment, "?embed"), words.frameTitle);
    const isLong = address.length > LONGEST_CODE;
    return html`
      ${isLong ? html`<p data-testid="no-code">${words.length(address.length)} ${words.noCode(LONGEST_CODE)}</p>` : codePicture(address, exercises.code)}
      ${link(address, "code-address")}
      ${LOCAL.test(location.hostname) ? html`<p class="hint">${code.local}</p>` : nothing}
      <details class="code-frame"><summary>${words.frame}</summary>
        <textarea readonly rows="3" aria-label=${words.frame} data-testid="frame-line" .value=${line}></textarea>
        <div><button class="small" @click=${copy(line)}>${words.copyFrame}</button></div></details>
      ${isLong ? shortLink() : nothing}`;
  }

  function content() {
    if (!withModel) return state(dared(fragment));
    if (problem !== "") return html`<p role="alert" data-testid="no-link">${problem}</p>${shortLink()}`;
    return carrying === null ? html`<p role="status">${words.making}</p>` : state(dared(carrying));
  }

  function draw(): void {
    render(
      html`
      <div class="dialog-body stack">
        <header><h2 id="code-title">${code.title}</h2>
          <button class="round" aria-label=${code.close} title=${code.close} @click=${() => dialog.close()}>${icon("close")}</button></header>
        ${offered.length > 0 ? dares() : nothing}
        ${model ? choice() : nothing}
        ${content()}
      </div>`,
      dialog,
    );
  }

  // Without its model, the link of a model that is on no host brings nothing to others.
  await carryModel(model !== null && !model.isOnHost);
  document.body.append(dialog);
  dialog.showModal();
  dialog.addEventListener("close", () => dialog.remove());
}
