// For tests: a visitor who is asked without a dialog. Use it as vi.mock("../ui/unsaved-dialog", () =>
// import("../ui/unsaved-dialog.fake")).
import type { Answer } from "./unsaved-dialog";

export const visitor = {
  /** What the questions were about. */
  asked: [] as string[],
  answer: "keep" as Answer,
  arrives(answer: Answer): void {
    [this.asked, this.answer] = [[], answer];
  },
};

export async function askInDialog(what: readonly string[]): Promise<Answer> {
  visitor.asked.push(...what);
  return visitor.answer;
}
