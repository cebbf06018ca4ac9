// For tests: a visitor who is asked without a dialog. Use it as vi.mock("../unsaved/choice-dialog", () =>
// import("../unsaved/choice-dialog.fake")).
import type { Choice } from "./choice-dialog";

export const visitor = {
  /** The texts of the questions. */
  asked: [] as string[],
  answer: "keep",
  arrives(answer: "save" | "discard" | "keep" | "yes"): void {
    [this.asked, this.answer] = [[], answer];
  },
};

export async function choose({ text, answers }: Choice<string>): Promise<string | null> {
  visitor.asked.push(text);
  return answers.find(([answer]) => answer === visitor.answer)?.[0] ?? null;
}
