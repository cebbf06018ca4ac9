// The base of all components: draws again when one of its topics changes. Light DOM, so that the page has one stylesheet.
import { LitElement } from "lit";
import type { App, Topic } from "../app/app";

export abstract class View extends LitElement {
  static topics: readonly Topic[] = [];
  declare app: App;
  private stop: (() => void) | undefined;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.stop = this.app.on((this.constructor as typeof View).topics, () => this.requestUpdate());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stop?.();
  }
}

/** A swatch in the colour of a part. */
export function swatchStyle(colour: string): string {
  return `--part:${colour}`;
}
