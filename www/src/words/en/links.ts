import { decimal } from "../../ui/decimal";
import type { LinkProblem } from "../../links/problem";

const number = (value: number) => decimal("en", value, 0);

function problems(problem: LinkProblem): string {
  switch (problem.what) {
    case "version":
      return `Expected a packed model of form ${problem.expected}, found “${problem.found}”: the link is of another version of this page, or damaged.`;
    case "cut":
      return `Expected ${number(problem.expected)} characters of a packed model, found ${number(problem.found)}: the link was cut off or changed on its way.`;
    case "character":
      return `Expected letters, digits, - and _ in the packed model, found “${problem.found}” as its character ${number(problem.place)}: the link was changed on its way.`;
    case "damaged":
      return "Expected a packed model whose check number fits, found another number: the link was changed on its way.";
    case "long":
      return `Expected at most ${number(problem.most)} characters in a link, found ${number(problem.found)}.`;
    case "large":
      return `Expected a model of at most ${number(problem.most)} bytes, found more.`;
    case "name":
      return `Expected the name of a JSON file on the host of this page, found “${problem.found}”.`;
    case "missing":
      return `Expected the file “${problem.file}” on the host of this page, found ${problem.found === "" ? "no answer" : `the answer ${problem.found}`}.`;
    case "browser":
      return "Expected a browser that can unpack models (Chrome 80, Firefox 113, Safari 16.4 or later), found another one.";
  }
}

/** Links that bring a model, and the dialog that makes them. */
export const words = {
  notOpened: "The model of this link was not opened",
  problems,
  withModel: "With the model in the link",
  withModelMeaning: "Opens on any machine, without a file. The link is long.",
  making: "Making the link",
  length: (characters: number) => `The link has ${number(characters)} characters.`,
  noCode: (most: number) =>
    `Too long for a QR code, which holds at most ${number(most)} characters: send the link.`,
  tooLong: (most: number, found: number) =>
    `The link would have ${number(found)} characters, more than ${number(most)}.`,
  /** A link of a file, in place of a long link. */
  short: {
    title: "A short link, with a QR code",
    how: "Save the model, and put its file on the host beside the page. Then this link opens it.",
    file: "File",
    save: "Save the model",
  },
  frame: "Show it on a page of your own",
  copyFrame: "Copy the line for your page",
  frameTitle: "A motion model",
};

export type LinkWords = typeof words;
