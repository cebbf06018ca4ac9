import { expect, it } from "vitest";
import model from "../../first/model.json?raw";
import { LARGEST_DOCUMENT } from "./bytes";
import { LONGEST, packed, unpacked } from "./packed-model";
import { LinkError } from "./problem";
import { positions, trainedDocument } from "./trained-model.fake";

/** What a link with this packed model says; null: it was unpacked. */
const problem = (text: string) =>
  unpacked(text).then(
    () => null,
    (thrown: unknown) => (thrown instanceof LinkError ? thrown.problem : thrown),
  );

/** A link with any text in it, right in length and check number. */
async function linkOf(text: string): Promise<string> {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const binary = [...bytes].map((byte) => String.fromCharCode(byte)).join("");
  const data = btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  return `1.${data.length}.${data}`;
}

it("brings a document back with seven digits, all fields, and symmetric matrices whole", async () => {
  const link = await packed(model);
  expect(link).toMatch(/^1\.\d+\.[\w-]+$/);
  // docs/page.md says how long.
  expect(link.length).toBeLessThan(24_000);
  const back = JSON.parse(await unpacked(link));
  const numbers = (value: unknown, path = ""): [string, unknown][] =>
    typeof value === "object" && value !== null
      ? Object.entries(value).flatMap(([name, entry]) => numbers(entry, `${path}.${name}`))
      : [[path, value]];
  const [before, after] = [numbers(JSON.parse(model)), numbers(back)];
  expect(after.map(([path]) => path)).toEqual(before.map(([path]) => path));
  for (const [place, [path, value]] of before.entries()) {
    const found = after[place]?.[1];
    if (typeof value !== "number") expect(found, path).toBe(value);
    else {
      const precision = path.includes("u_covariance") ? 0.06 : 6e-7;
      expect(Math.abs(Number(found) - value), path).toBeLessThanOrEqual(precision * Math.abs(value));
    }
  }
});

it("moves joints by less than 3 mm in ten seconds, also where other couplings infer experts again", async () => {
  const document = await trainedDocument();
  const back = await unpacked(await packed(document));
  for (const factor of [0.05, 1, 100]) {
    const [before, after] = [positions(document, factor), positions(back, factor)];
    const apart = before.map((value, i) => Math.abs(value - (after[i] ?? Number.NaN)));
    expect(Math.max(...apart), `factor ${factor}`).toBeLessThan(3e-3);
  }
}, 60_000);

it("makes the same link of a document that came by a link", async () => {
  const link = await packed(model);
  expect(await packed(await unpacked(link))).toBe(link);
});

it("says what is wrong with a link that is cut off, damaged, or of another version", async () => {
  const link = await packed(model);
  const [, length, data = ""] = link.split(".");
  expect(await problem(link.slice(0, -100))).toEqual({
    what: "cut",
    expected: Number(length),
    found: Number(length) - 100,
  });
  const longer = { what: "cut", expected: Number(length), found: Number(length) + 1 };
  expect(await problem(`${link}A`)).toEqual(longer);
  expect(await problem("1.40")).toEqual({ what: "cut", expected: 40, found: 0 });
  expect(await problem("1.-4.AAAA")).toEqual({ what: "damaged" });
  expect(await problem(`2.${length}.${data}`)).toEqual({ what: "version", expected: "1", found: "2" });
  expect(await problem(`1.${length}.%${data.slice(1)}`)).toEqual({ what: "character", found: "%", place: 1 });
  for (const place of [4, 1000, data.length - 3]) {
    const other = data[place] === "A" ? "B" : "A";
    const changed = data.slice(0, place) + other + data.slice(place + 1);
    expect(await problem(`1.${length}.${changed}`), `${place}`).toEqual({ what: "damaged" });
  }
  const half = data.slice(0, 4000);
  expect(await problem(`1.${half.length}.${half}`)).toEqual({ what: "damaged" });
  expect(await problem("1.5.AAAAA")).toEqual({ what: "damaged" });
});

it("refuses a text that is too long, or that unpacks to too many bytes", async () => {
  const long = "A".repeat(LONGEST);
  const found = `1.${LONGEST}.`.length + LONGEST;
  expect(await problem(`1.${LONGEST}.${long}`)).toEqual({ what: "long", most: LONGEST, found });
  const bomb = await linkOf(" ".repeat(LARGEST_DOCUMENT + 1));
  expect(bomb.length).toBeLessThan(LONGEST);
  expect(await problem(bomb)).toEqual({ what: "large", most: LARGEST_DOCUMENT });
  expect(await problem(await linkOf(" ".repeat(LARGEST_DOCUMENT)))).toBe(null);
});

it("refuses matrices within matrices at once, which would double at each level", async () => {
  let nested = "1";
  for (let depth = 0; depth < 60; depth++) nested = `{"sum_psi2":[[0],[${nested},0]]}`;
  const link = await linkOf(nested);
  const begin = performance.now();
  expect((await unpacked(link)).length).toBeLessThan(2 * nested.length);
  expect(performance.now() - begin).toBeLessThan(100);
});

it("holds the whole matrices against the limit too", async () => {
  const rows = Array.from({ length: 1_400 }, (_, i) => `[${"1234,".repeat(i)}1]`);
  expect(await problem(await linkOf(`{"sum_psi2":[${rows.join(",")}]}`))).toEqual({
    what: "large",
    most: LARGEST_DOCUMENT,
  });
});

it("makes no link that it would not open", async () => {
  const numbers = Array.from({ length: 60_000 }, (_, i) => Math.sin(i));
  await expect(packed(JSON.stringify(numbers))).rejects.toMatchObject({
    problem: { what: "long", most: LONGEST },
  });
});

it("keeps the digits by which experts that are inferred again, and MAP models, move", async () => {
  const sums = ["sum_psi2", "sum_psi1_mu", "other_precision", "other_b"].map(
    (name) => `"${name}":[[1.23456789012]]`,
  );
  const document = `{${sums.join(",")},"latents":[[1.23456789]],"coefficients":[[1.23456789]]}`;
  expect(await unpacked(await packed(document))).toBe(document);
});

it("keeps both halves of a matrix that is not symmetric", async () => {
  const document = '{"v_covariance":[[1,2],[3,4]],"sum_psi2":[[1,2],[2,4]]}';
  expect(await unpacked(await packed(document))).toBe(document);
});

it("leaves a document that is no JSON, and matrices of other shapes, to the reader of models", async () => {
  const text = async (value: string) => unpacked(await linkOf(value));
  for (const value of ["", "{", "[".repeat(1_000_000)]) expect(await text(value)).toBe(value);
  for (const value of ['{"sum_psi2":[[1],[2]]}', '{"sum_psi2":7}', '{"u_covariance":[[1,2],[3,4]]}'])
    expect(await text(value)).toBe(value);
  expect(await text('{"sum_psi2":[[1],[2,3]]}')).toBe('{"sum_psi2":[[1,2],[2,3]]}');
});
