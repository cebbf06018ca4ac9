// Tests that `npm test` leaves out, and `npm test -- --all` runs.
import { describe, it } from "node:test";

/** Whether this is `npm test`, neither `npm test -- --all` nor a run by hand. */
export const often = process.env.PAGE_TESTS === "often";

/** `it` and `describe` of what a change seldom breaks: `npm test` leaves these tests out. */
export const seldom = often ? { it: it.skip, describe: describe.skip } : { it, describe };
