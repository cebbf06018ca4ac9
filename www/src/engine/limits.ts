// Limits of the page.

/** The maximum number of parts of a body. The page has colours and space for this many. */
export const MAX_PARTS = 8;

/** The largest coupling variance that a training or a fit can reach. A browser test compares it with a fit. */
export const LARGEST_COUPLING = 10;
