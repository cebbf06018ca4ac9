// Limits of the page.

/** The maximum number of parts of a body. The page has colours and space for this many. */
export const MAX_PARTS = 8;
