// How long a file is.

/** Lines that are neither empty nor a comment. `*` alone begins a line of a comment, `*x` a line of code. */
const linesOfCode = (/** @type {string} */ text) =>
  text.split("\n").filter((line) => !/^\s*($|\/\/|\/\*|\*(\s|\/|$))/.test(line)).length;

/**
 * The files with more lines of code than allowed.
 * @param {Map<string, string>} sources the text of each file
 * @param {number} allowed
 */
export const longFiles = (sources, allowed) =>
  [...sources]
    .map(([file, text]) => ({ file, lines: linesOfCode(text) }))
    .filter(({ lines }) => lines > allowed)
    .map(({ file, lines }) => `${file}: ${lines} lines`);
