// The reasons why a link cannot be opened. Their sentences are in words/links.

export type LinkProblem =
  /** The form of the packed model is not the one of this version: the text before the first point. */
  | { what: "version"; expected: string; found: string }
  /** The number of characters that the link says it has, and that it has. */
  | { what: "cut"; expected: number; found: number }
  /** A character that is not in packed models, and its place from 1. */
  | { what: "character"; found: string; place: number }
  /** The check number of the packed model does not fit. */
  | { what: "damaged" }
  /** Characters of a link. */
  | { what: "long"; most: number; found: number }
  /** Bytes of a document. */
  | { what: "large"; most: number }
  /** The name is not that of a JSON file on the page's own host. */
  | { what: "name"; found: string }
  /** The answer of the host to a request for a file. */
  | { what: "missing"; file: string; found: string }
  /** The browser cannot unpack. */
  | { what: "browser" };

export class LinkError extends Error {
  constructor(readonly problem: LinkProblem) {
    super(`link: ${problem.what}`);
  }
}
