import type { App } from "../../app/app";
import "../../stage/stage-view";
import { storyBody } from "../body";
import { loadReplies } from "../../words/replies";
import type { Chapter } from "../chapter";
import { EndChapter } from "./end-chapter";

export async function openChapter(app: App): Promise<Chapter> {
  await loadReplies(app.words);
  return new EndChapter(storyBody(app));
}
