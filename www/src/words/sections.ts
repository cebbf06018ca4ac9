// The words of parts of the page that few visitors open. Each loads at its first use; then its function gives the
// words in the present language.
import { viewWords } from "./section";

export type { Replies } from "./en/replies";

const completing = viewWords({ en: () => import("./en/completing"), de: () => import("./de/completing") });
/** A recording that gives one part. */
export const completingWords = completing.now;
export const loadCompleting = completing.load;

const help = viewWords({ en: () => import("./en/help"), de: () => import("./de/help") });
export const helpWords = help.now;
export const loadHelp = help.load;

const panel = viewWords({ en: () => import("./en/numbers"), de: () => import("./de/numbers") });
/** The panel Numbers. */
export const numbers = panel.now;
export const loadNumbers = panel.load;

const replies = viewWords({ en: () => import("./en/replies"), de: () => import("./de/replies") });
/** What the story says to a guess, by chapter and answer; null: it has not loaded. */
export const repliesNow = replies.ifLoaded;
export const loadReplies = replies.load;

const session = viewWords({ en: () => import("./en/session"), de: () => import("./de/session") });
/** The words about earlier visits. */
export const sessionWords = session.now;
export const loadSession = session.load;
