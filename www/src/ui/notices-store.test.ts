import { expect, it } from "vitest";
import { NoticesStore } from "./notices-store";

it("keeps the newest six notices, until they are dismissed or cleared", () => {
  const notices = new NoticesStore();
  for (let i = 1; i <= 8; i++) notices.addError(`file ${i}`, "");
  const titles = () => notices.all.map(({ title }) => title.slice(-1)).join("");
  expect(titles()).toBe("345678");
  notices.dismiss(notices.all[1]?.id ?? 0);
  expect(titles()).toBe("35678");
  notices.clear();
  expect(titles()).toBe("");
});

it("has a notice with the same words once, as the newest", () => {
  const notices = new NoticesStore();
  for (const text of ["one", "two", "one", "one"]) notices.addError("Stopped", text);
  expect(notices.all.map(({ text }) => text)).toEqual(["two", "one"]);
});
