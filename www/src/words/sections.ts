// The words of parts of the page that few visitors open. Each loads at its first use; then its function gives the
// words in the present language.
import { viewWords } from "./section";

export type { Replies } from "./en/replies";
export type { TeachWords } from "./en/teach";

const completing = viewWords({ en: () => import("./en/completing"), de: () => import("./de/completing") });
/** A recording that gives one part. */
export const completingWords = completing.now;
export const loadCompleting = completing.load;

const help = viewWords({ en: () => import("./en/help"), de: () => import("./de/help") });
export const helpWords = help.now;
export const loadHelp = help.load;

const links = viewWords({ en: () => import("./en/links"), de: () => import("./de/links") });
/** Links that bring a model. */
export const linkWords = links.now;
export const loadLinks = links.load;

const panel = viewWords({ en: () => import("./en/numbers"), de: () => import("./de/numbers") });
/** The panel Numbers. */
export const numbers = panel.now;
export const loadNumbers = panel.load;

const performing = viewWords({ en: () => import("./en/performing"), de: () => import("./de/performing") });
/** What a visitor does live and records. */
export const performingWords = performing.now;
export const loadPerforming = performing.load;

const replies = viewWords({ en: () => import("./en/replies"), de: () => import("./de/replies") });
/** What the story says to a guess, by chapter and answer; null: it has not loaded. */
export const repliesNow = replies.ifLoaded;
export const loadReplies = replies.load;

const session = viewWords({ en: () => import("./en/session"), de: () => import("./de/session") });
/** The words about earlier visits. */
export const sessionWords = session.now;
export const loadSession = session.load;

const teach = viewWords({ en: () => import("./en/teach"), de: () => import("./de/teach") });
/** The page for teachers, the slides and the exercises; null: the words have not loaded. */
export const teachIfLoaded = teach.ifLoaded;
export const teachWords = teach.now;
export const loadTeach = teach.load;
