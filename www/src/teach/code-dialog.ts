// A dialog with the QR code and the link of a state of the page.
import { html, nothing, render } from "lit";
import type { App } from "../app/app";
import "../ui/dialog.css";
import { icon } from "../ui/icons";
import { teachWords } from "../words/teach";
import { addressOf, codeOf } from "./code";
import "./code.css";

/** Hosts that no other machine can reach. */
const LOCAL = /^(localhost|127\.|\[::1\]|$)/;

/** The code as a picture, dark on white. */
export function codePicture(address: string, label: string) {
  const { side, path } = codeOf(address);
  return html`<svg class="code-picture" role="img" aria-label=${label} viewBox="0 0 ${side} ${side}" shape-rendering="crispEdges"><path d=${path}></path></svg>`;
}

export async function showCode(app: App, fragment: string): Promise<void> {
  if (document.querySelector(".code-dialog")) return;
  const section = teachWords(app.words);
  await section.load();
  const { code, exercises } = section.now;
  const address = addressOf(fragment);
  const dialog = document.createElement("dialog");
  dialog.className = "code-dialog";
  dialog.setAttribute("aria-labelledby", "code-title");
  dialog.dataset.testid = "code";
  const copy = async ({ currentTarget }: Event) => {
    const button = currentTarget as HTMLButtonElement;
    await navigator.clipboard.writeText(address);
    button.textContent = code.copied;
  };
  render(
    html`
    <div class="dialog-body">
      <header><h2 id="code-title">${code.title}</h2>
        <button class="round" aria-label=${code.close} title=${code.close} @click=${() => dialog.close()}>${icon("close")}</button></header>
      ${codePicture(address, exercises.code)}
      <p class="code-address"><a href=${address} data-testid="code-address" @click=${() => dialog.close()}>${address}</a></p>
      ${LOCAL.test(location.hostname) ? html`<p class="hint">${code.local}</p>` : nothing}
      ${app.isLab && app.model.openedText !== null ? html`<p class="hint">${code.model}</p>` : nothing}
      <div class="button-row"><button class="small" data-testid="copy-address" @click=${(event: Event) => void copy(event)}>${code.copy}</button></div>
    </div>`,
    dialog,
  );
  document.body.append(dialog);
  dialog.showModal();
  dialog.addEventListener("close", () => dialog.remove());
}
