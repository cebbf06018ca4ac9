import type { App } from "../../app/app";
import "../../stage/stage-view";
import { loadReplies } from "../../words/sections";
import type { Chapter } from "../chapter";
import { EndChapter } from "./end-chapter";

export async function openChapter(app: App): Promise<Chapter> {
  await loadReplies(app.words);
  return new EndChapter(app.story);
}
