// The names of the views, which are in the page's address.

/** The stores of each view. A view adds its own: views/define-view.ts. */
export interface ViewStores {
  /** The Lab, which shows the stores of the page itself. */
  play: null;
}

export type ViewName = keyof ViewStores;

/** The build finds the other views: scripts/views.mjs. */
declare const VIEW_NAMES: readonly ViewName[];

export const VIEWS: readonly ViewName[] = ["play", ...VIEW_NAMES];
