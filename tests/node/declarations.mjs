// Reads the types that the package declares, as far as it uses the language, and holds values against them.

/**
 * @typedef {{ kind: "primitive", name: string } | { kind: "literal", value: string } | { kind: "name", name:
 * string }
 *   | { kind: "list", item: Type } | { kind: "tuple", items: Type[] } | { kind: "union", options: Type[] }
 *   | { kind: "object", fields: Map<string, { type: Type, optional: boolean }> }} Type
 */

const PRIMITIVES = ["string", "number", "boolean", "null", "void", "undefined"];

/**
 * The types of a declaration file, and what its functions and the functions and fields of its classes answer
 * with.
 */
export function readDeclarations(/** @type {string} */ text) {
  const source = text.replace(/\/\*[\s\S]*?\*\//g, "");
  /** @type {Map<string, Type>} */
  const types = new Map();
  for (const { 1: name = "", 2: base = "", index } of source.matchAll(
    /^export interface (\w+)(?: extends ([^{]+?))? (?=\{)/gm,
  ))
    types.set(name, extended(readType(source.slice(source.indexOf("{", index))), base, types));
  for (const { 0: start, 1: name = "", index } of source.matchAll(/^export type (\w+) =/gm))
    types.set(name, readType(source.slice(index + start.length)));
  /** @type {Map<string, Type>} */
  const answers = new Map();
  for (const [, name = "", body = ""] of source.matchAll(/^export class (\w+) \{([\s\S]*?)^\}/gm))
    for (const [, method = "", type = ""] of body.matchAll(/^ +(?:static )?(\w+)\([^)]*\): (.+);$/gm))
      answers.set(`${name}.${method}`, readType(type));
  for (const [, name = "", body = ""] of source.matchAll(/^export class (\w+) \{([\s\S]*?)^\}/gm))
    for (const [, field = "", type = ""] of body.matchAll(/^ +readonly (\w+): (.+);$/gm))
      answers.set(`${name}.${field}`, readType(type));
  for (const [, name = "", type = ""] of source.matchAll(/^export function (\w+)\(.*\): (.+);$/gm))
    answers.set(name, readType(type));
  return { types, answers };
}

/**
 * With the fields of the type that it extends, which is declared before it: a name, or Omit<name, "field" |
 * "field">.
 * @param {Type} type
 * @param {string} base
 * @param {Map<string, Type>} types
 * @returns {Type}
 */
function extended(type, base, types) {
  const [, name = base, omitted = ""] = /^Omit<(\w+), (.+)>$/.exec(base) ?? [];
  const known = types.get(name);
  if (type.kind !== "object" || known?.kind !== "object") return type;
  const kept = [...known.fields].filter(([field]) => !omitted.includes(`"${field}"`));
  return { kind: "object", fields: new Map([...kept, ...type.fields]) };
}

/** @returns {Type} */
function readType(/** @type {string} */ text) {
  const tokens = [...text.matchAll(/"[^"]*"|\w+|[{}[\]()|:;,?]/g)].map(([token]) => token);
  let next = 0;
  const take = () => tokens[next++] ?? "";
  const skip = (/** @type {string} */ token) => tokens[next] === token && next++ >= 0;

  /** @returns {Type} */
  function union() {
    skip("|");
    const options = [list()];
    while (skip("|")) options.push(list());
    const [only] = options;
    return options.length === 1 && only ? only : { kind: "union", options };
  }
  /** @returns {Type} */
  function list() {
    let type = single();
    while (tokens[next] === "[" && tokens[next + 1] === "]") {
      next += 2;
      type = { kind: "list", item: type };
    }
    return type;
  }
  /** @returns {Type} */
  function single() {
    const token = take();
    if (token.startsWith('"')) return { kind: "literal", value: token.slice(1, -1) };
    if (token === "(") {
      const inner = union();
      skip(")");
      return inner;
    }
    if (token === "[") {
      const items = [];
      while (!skip("]")) {
        items.push(union());
        skip(",");
      }
      return { kind: "tuple", items };
    }
    if (token !== "{")
      return PRIMITIVES.includes(token) ? { kind: "primitive", name: token } : { kind: "name", name: token };
    const fields = new Map();
    while (!skip("}")) {
      const name = take();
      const optional = skip("?");
      skip(":");
      fields.set(name, { type: union(), optional });
      skip(";");
    }
    return { kind: "object", fields };
  }
  return union();
}

/**
 * What a value has that its type has not, and the other way round; empty when they agree.
 * @param {Map<string, Type>} types
 * @param {Type} type
 * @param {unknown} value
 * @param {string} path
 * @param {Set<string>} seen the named types that were held against a value
 * @returns {string[]}
 */
export function differences(types, type, value, path, seen = new Set()) {
  const inner = (/** @type {Type} */ type, /** @type {unknown} */ value, /** @type {string} */ step) =>
    differences(types, type, value, `${path}${step}`, seen);
  const found = () =>
    `${path}: found ${value === undefined ? "nothing" : JSON.stringify(value).slice(0, 80)}`;
  switch (type.kind) {
    case "primitive":
      return (value === null ? "null" : typeof value) === type.name
        ? []
        : [`${found()}, declared ${type.name}`];
    case "literal":
      return value === type.value ? [] : [`${found()}, declared "${type.value}"`];
    case "name": {
      const named = types.get(type.name);
      if (!named) return [`${path}: the type ${type.name} is not declared`];
      const problems = inner(named, value, "");
      if (problems.length === 0) seen.add(type.name);
      return problems;
    }
    case "list":
      if (!Array.isArray(value)) return [`${found()}, declared as a list`];
      return value.flatMap((item, k) => inner(type.item, item, `[${k}]`));
    case "tuple":
      if (!Array.isArray(value) || value.length !== type.items.length)
        return [`${found()}, declared as a tuple`];
      return type.items.flatMap((item, k) => inner(item, value[k], `[${k}]`));
    case "union": {
      const each = type.options.map((option) => inner(option, value, ""));
      return each.some((problems) => problems.length === 0)
        ? []
        : [`${found()}: none of what is declared: ${each.flat().join("; ")}`];
    }
    case "object": {
      if (typeof value !== "object" || value === null) return [`${found()}, declared as an object`];
      const unknown = Object.keys(value).filter((key) => !type.fields.has(key));
      const fields = [...type.fields].flatMap(([name, { type, optional }]) => {
        const entry = /** @type {Record<string, unknown>} */ (value)[name];
        return optional && entry === undefined ? [] : inner(type, entry, `.${name}`);
      });
      return [...unknown.map((key) => `${path}.${key} is not declared`), ...fields];
    }
  }
}
