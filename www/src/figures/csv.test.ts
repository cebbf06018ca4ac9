import { expect, it } from "vitest";
import { csv, FORMULA_SIGNS } from "./csv";
import library from "../../../crate/core/src/series/csv.rs?raw";

it("quotes fields with special characters, and ends each line with CR and LF", () => {
  expect(
    csv({
      header: ["model", 'a "b"'],
      rows: [
        ["x, y", "two\nlines"],
        ["plain", ""],
      ],
    }),
  ).toBe('model,"a ""b"""\r\n"x, y","two\nlines"\r\nplain,\r\n');
});

it("keeps full precision, and leaves unknown values empty", () => {
  const value = 0.1 + 0.2;
  const [, row] = csv({ header: ["a", "b", "c", "d"], rows: [[value, 1e-9, null, Number.NaN]] }).split(
    "\r\n",
  );
  expect(row).toBe("0.30000000000000004,1e-9,,");
  expect(Number(row!.split(",")[0])).toBe(value);
});

it("makes texts of names that a spreadsheet would compute", () => {
  const header = ['=HYPERLINK("http://x")', "+1", "@a", "-b", "a-b"];
  expect(csv({ header, rows: [[-1]] })).toBe(`"'=HYPERLINK(""http://x"")",'+1,'@a,'-b,a-b\r\n-1\r\n`);
});

it("guards against the same signs as the library", () => {
  const [, signs] = /FORMULA_SIGNS: &str = (".*");/.exec(library) ?? [];
  expect(JSON.parse(signs ?? "")).toBe(FORMULA_SIGNS);
  expect(csv({ header: [...FORMULA_SIGNS], rows: [] }).match(/'/g)).toHaveLength(FORMULA_SIGNS.length);
});
