// The equations of the model in MathML, which browsers draw. They are constants and words of the page: no text
// of a visitor is in them.
import type { MethodWords } from "./en";

const tag = (name: string, inner: string, attributes = "") => `<${name}${attributes}>${inner}</${name}>`;
const row = (...parts: string[]) => tag("mrow", parts.join(""));
/** A letter in italics; several letters are upright, as names of functions are. */
const id = (name: string) => tag("mi", name);
const num = (value: string) => tag("mn", value);
const op = (sign: string) => tag("mo", sign);
/** Words; only a non-breaking blank survives at their end. */
const text = (words: string) => tag("mtext", words.replace(/ $/, "\u00a0"));
const sub = (base: string, below: string) => tag("msub", base + below);
const sup = (base: string, above: string) => tag("msup", base + above);
const both = (base: string, below: string, above: string) => tag("msubsup", base + below + above);
const over = (above: string, below: string) => tag("mfrac", above + below);
const sum = (index: string) => tag("munder", op("∑") + index);
const bracket = (sign: string) => tag("mo", sign, ' stretchy="false"');
const call = (f: string, ...given: string[]) => row(f, bracket("("), given.join(op(",")), bracket(")"));
/** Browsers put no space next to the name of a function. */
const thin = `<mspace width="0.17em"></mspace>`;
const log = (of: string) => row(thin, id("log"), op("\u2061"), thin, of);
const inverse = (matrix: string) => sup(matrix, row(op("−"), num("1")));

const i = id("i");
const j = id("j");
const ji = row(j, i);
const t = id("t");
const one = num("1");
const x = id("x");
const K = id("K");
const n = id("n");
const history = (part: string) => both(x, row(op("−"), t), part);
const alpha = (above: string) => sup(id("α"), above);
const w = sub(id("w"), ji);
const f = sup(id("f"), ji);
const normal = (mean: string, variance: string) => call(id("𝒩"), mean, variance);
const psi = (index: string) => sub(id("Ψ"), num(index));
/** Expectation. Browsers no longer make letters bold by an attribute, so that the letter itself is bold. */
const E = id("𝐄");
const A = id("A");
const b = id("b");

/** The space between two equations in a line. */
const apart = `${op(",")}<mspace width="1.2em"></mspace>`;

const math = (...parts: string[]) => `<math display="block">${row(...parts)}</math>`;
const inline = (...parts: string[]) => `<math>${row(...parts)}</math>`;

export const EQUATIONS = {
  dynamics: math(both(x, t, i), op("∼"), normal(row(sum(j), w, call(f, history(j))), row(alpha(i), id("I")))),
  weights: math(
    alpha(i),
    op("="),
    over(one, row(sum(j), over(one, alpha(ji)))),
    apart,
    w,
    op("="),
    over(alpha(i), alpha(ji)),
    apart,
    sum(j),
    w,
    op("="),
    one,
  ),
  history: math(
    history(j),
    op("="),
    call("", both(x, row(t, op("−"), id("p")), j), op("…"), both(x, row(t, op("−"), one), j)),
  ),
  expert: math(f, op("∼"), call(id("GP"), num("0"), id("k"))),
  kernel: math(
    call(id("k"), x, sup(x, op("′"))),
    op("="),
    id("exp"),
    op("("),
    op("−"),
    over(one, num("2")),
    sum(id("q")),
    over(
      sup(row(op("("), sub(x, id("q")), op("−"), both(x, id("q"), op("′")), op(")")), num("2")),
      sub(id("λ"), id("q")),
    ),
    op(")"),
  ),
  pose: math(
    both(id("y"), t, i),
    op("∼"),
    normal(call(sup(id("g"), i), both(x, t, i)), row(sup(id("β"), i), id("I"))),
    apart,
    sup(id("g"), i),
    op("∼"),
    call(id("GP"), num("0"), row(sup(id("σ"), num("2")), id("k"))),
  ),
  collapsed: math(
    id("F"),
    op("="),
    op("−"),
    over(row(id("R"), id("C")), num("2")),
    log(call("", row(num("2"), id("π"), n))),
    op("−"),
    over(sub(id("c"), num("2")), row(num("2"), n)),
    op("+"),
    over(id("C"), num("2")),
    log(over(row(op("|"), K, op("|")), row(op("|"), A, op("|")))),
    op("+"),
    over(row(id("tr"), op("("), sup(b, op("⊤")), inverse(A), b, op(")")), row(num("2"), sup(n, num("2")))),
    op("−"),
    over(row(id("C"), id("Δ")), row(num("2"), n)),
  ),
  posterior: math(
    A,
    op("="),
    K,
    op("+"),
    over(psi("2"), n),
    apart,
    call(E, id("u")),
    op("="),
    over(row(K, inverse(A), b), n),
  ),
  rollout: math(
    both(x, t, i),
    op("="),
    sum(j),
    w,
    call(id("k"), history(j), sup(id("z"), ji)),
    inverse(both(K, text("zz"), ji)),
    call(E, sup(id("u"), ji)),
  ),
  tmp: math(
    call(sub(id("y"), id("k")), t),
    op("="),
    sum(id("q")),
    sub(id("w"), row(id("k"), id("q"))),
    call(sub(id("m"), id("q")), t),
    op("+"),
    id("ε"),
    apart,
    sub(id("m"), id("q")),
    op("∼"),
    call(id("GP"), num("0"), id("k")),
  ),
  dmp: math(
    id("τ"),
    over(row(id("d"), id("v")), row(id("d"), t)),
    op("="),
    sub(id("α"), id("z")),
    call("", row(sub(id("β"), id("z")), call("", row(id("g"), op("−"), id("y"))), op("−"), id("v"))),
    op("+"),
    call(id("f"), id("s")),
    apart,
    id("τ"),
    over(row(id("d"), id("y")), row(id("d"), t)),
    op("="),
    id("v"),
  ),
  map: math(
    sup(id("X"), i),
    op("∼"),
    normal(num("0"), row(sum(j), both(id("w"), ji, num("2")), sup(K, ji), op("+"), alpha(i), id("I"))),
    apart,
    id("X"),
    op("="),
    id("arg max"),
    thin,
    call(id("p"), id("Y"), id("X")),
  ),
} as const;

/** The equations with words in them. */
export const equationsWith = (words: MethodWords["inEquations"]) => ({
  bound: math(
    sub(id("F"), id("γ")),
    op("="),
    sum(i),
    sub(id("γ"), i),
    sub(id("F"), row(text(words.poses), i)),
    op("+"),
    sum(i),
    sub(id("F"), row(text(words.dynamics), i)),
    op("+"),
    text(words.firstFrames),
    op("+"),
    text(words.entropy),
    apart,
    sub(id("F"), one),
    op("≤"),
    log(call(id("p"), id("Y"))),
  ),
  score: math(
    call(id("P"), text(words.natural)),
    op("="),
    over(num("0.5"), row(one, op("+"), id("exp"), call("", row(id("a"), thin, id("MSE"), op("+"), id("c"))))),
  ),
});

export const SYMBOLS = {
  parts: inline(i, op(","), j),
  latent: inline(both(x, t, i)),
  history: inline(history(j)),
  order: inline(id("p")),
  dimensions: inline(id("Q")),
  coupling: inline(alpha(ji)),
  weight: inline(w),
  expert: inline(f),
  dynamicsPoints: inline(sup(id("z"), ji), op(","), sup(id("u"), ji)),
  dynamicsCount: inline(K),
  poseMap: inline(sup(id("g"), i)),
  posePoints: inline(sup(id("r"), i), op(","), sup(id("v"), i)),
  poseCount: inline(id("L")),
  pose: inline(both(id("y"), t, i)),
  noise: inline(sup(id("β"), i)),
  lengths: inline(sub(id("λ"), id("q"))),
  bound: inline(id("ELBO")),
  frames: inline(t),
} as const;
