// What the page has room for.

/** Parts of a body: more have no colours, and their couplings no room. */
export const MAX_PARTS = 8;
