// Words about what went wrong, where it went wrong: at the place of a drop, or in the list of clips.
import { html, type TemplateResult } from "lit";
import type { App, Notice } from "../app/app";
import { icon } from "./icons";
import { View } from "./view";

export function noticeCard(app: App, { id, kind, title, text }: Notice): TemplateResult {
  return html`
    <div class="notice ${kind}" role=${kind === "error" ? "alert" : "status"} data-testid="notice">
      <div><strong>${title}</strong><p>${text}</p></div>
      <button class="round" aria-label="Dismiss" @click=${() => app.dismiss(id)}>${icon("close")}</button>
    </div>`;
}

export class NoticesView extends View {
  static override topics = ["notices"] as const;

  protected override render() {
    const dropped = this.app.notices.filter(({ at }) => at !== null);
    if (dropped.length === 0) return html``;
    const at = dropped.at(-1)!.at!;
    const left = Math.max(12, Math.min(at.x - 20, innerWidth - 372));
    const top = Math.max(12, Math.min(at.y - 20, innerHeight - 60 - 80 * dropped.length));
    return html`<div class="dropped-notices" style="left:${left}px;top:${top}px">
      ${dropped.map((notice) => noticeCard(this.app, notice))}</div>`;
  }
}
customElements.define("pg-notices", NoticesView);
