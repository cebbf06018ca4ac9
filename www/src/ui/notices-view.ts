// Notices at the place of a drop; those without a place are in a corner of the Lab.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "./icons";
import "./notices.css";
import type { Notice, NoticesStore } from "./notices-store";
import { View } from "./view";
import { styled } from "./styled";

/** `dismiss`: the label of the button. */
export function noticeCard(
  notices: NoticesStore,
  { id, kind, title, text }: Notice,
  dismiss: string,
): TemplateResult {
  return html`
    <div class="notice ${kind}" role=${kind === "error" ? "alert" : "status"} data-testid="notice">
      <div><strong>${title}</strong><p>${text}</p></div>
      <button class="round" aria-label=${dismiss} @click=${() => notices.dismiss(id)}>${icon("close")}</button>
    </div>`;
}

export class NoticesView extends View {
  static override properties = { inLab: { type: Boolean }, dismiss: {} };
  declare notices: NoticesStore;
  /** Other views show the notices without a place themselves. */
  declare inLab: boolean;
  /** The label of the buttons. */
  declare dismiss: string;

  protected override render() {
    const cards = (notices: readonly Notice[]) =>
      notices.map((notice) => noticeCard(this.notices, notice, this.dismiss));
    const dropped = this.notices.all.filter(({ at }) => at !== null);
    const others = this.inLab ? this.notices.all.filter(({ at }) => at === null) : [];
    const at = dropped.at(-1)?.at;
    const corner =
      others.length > 0 ? html`<div class="dropped-notices corner">${cards(others)}</div>` : nothing;
    if (!at) return corner;
    const left = Math.max(12, Math.min(at.x - 20, innerWidth - 372));
    const top = Math.max(12, Math.min(at.y - 20, innerHeight - 60 - 80 * dropped.length));
    return html`${corner}<div class="dropped-notices" style=${styled({ left: `${left}px`, top: `${top}px` })}>${cards(dropped)}</div>`;
  }
}
customElements.define("pg-notices", NoticesView);
