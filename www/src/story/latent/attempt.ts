import { messageOf } from "../../ui/format";
import type { StoryBody } from "../../app/story-body";

/** Waits for work of a chapter; the frame shows the reason when it fails. */
export function attempt(body: StoryBody, work: Promise<unknown>): void {
  work.catch((problem: unknown) => body.notices.addError(messageOf(problem), ""));
}
