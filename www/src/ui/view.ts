// The base of all components: redraws when one of its stores changes. It has no shadow DOM, so that the
// styles of the page apply.
import { LitElement } from "lit";
import { languageChanges } from "./language";
import { type Observed, Store } from "./store";

export abstract class View extends LitElement {
  readonly #leaving: (() => void)[] = [];

  /** The stores whose changes redraw this view: those that it was given, unless it says otherwise. */
  protected stores(): readonly Observed[] {
    return Object.values(this).filter((value) => value instanceof Store);
  }

  /** The view is drawn and on the page. Subclasses begin to listen here. */
  protected arrived(): void {}

  /** Calls back when the view leaves the page. */
  protected whenLeaving(stop: () => void): void {
    this.#leaving.push(stop);
  }

  /** Listens to an event until the view leaves the page. */
  protected listen(target: EventTarget, type: string, handler: (event: Event) => void): void {
    const ended = new AbortController();
    target.addEventListener(type, handler, { signal: ended.signal });
    this.whenLeaving(() => ended.abort());
  }

  /** Sends an event, which bubbles. */
  protected tell(type: string, detail?: unknown): void {
    this.dispatchEvent(new CustomEvent(type, { detail, bubbles: true }));
  }

  /** Calls back when the size of an element changes, until the view leaves the page. */
  protected watchSize(element: Element, resized: () => void): void {
    const observer = new ResizeObserver(resized);
    observer.observe(element);
    this.whenLeaving(() => observer.disconnect());
  }

  protected override createRenderRoot(): HTMLElement {
    this.classList.add("view");
    return this;
  }

  override connectedCallback(): void {
    // Fields with an initial value hide Lit's accessors.
    for (const name of (this.constructor as typeof LitElement).elementProperties.keys()) {
      if (!Object.hasOwn(this, name)) continue;
      const value = Reflect.get(this, name);
      Reflect.deleteProperty(this, name);
      Reflect.set(this, name, value);
    }
    super.connectedCallback();
    for (const store of [languageChanges, ...this.stores()])
      this.whenLeaving(store.on(() => this.requestUpdate()));
    if (this.hasUpdated) this.arrived();
  }

  protected override firstUpdated(): void {
    this.arrived();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const stop of this.#leaving.splice(0)) stop();
  }
}
