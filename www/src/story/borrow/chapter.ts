import type { App } from "../../app/app";
import type { Chapter } from "../chapter";
import "./borrow-figure";
import "./borrow.css";
import { BorrowChapter } from "./borrow-chapter";

export async function openChapter(app: App): Promise<Chapter> {
  const { library } = await app.view("primitives").get();
  return new BorrowChapter(app.words, app.settings, library);
}
