// Limits of the page.

/** The most parts of a body: there are colours and space for so many. */
export const MAX_PARTS = 8;
