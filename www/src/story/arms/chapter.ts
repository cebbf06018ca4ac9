import type { App } from "../../app/app";
import "../../couplings/phase-clock";
import "../../stage/stage-view";
import type { Chapter } from "../chapter";
import { ArmsChapter } from "./arms-chapter";
import "./arms.css";
import "./thread-view";

export async function openChapter(app: App): Promise<Chapter> {
  return new ArmsChapter(app.words, app.story);
}
