import type { App } from "../../app/app";
import "../../stage/stage-view";
import type { Chapter } from "../chapter";
import { PushChapter } from "./push-chapter";
import "./push-hands";
import "./push-loops";
import "./push.css";

export async function openChapter(app: App): Promise<Chapter> {
  return new PushChapter(app.words, app.story);
}
