// docs/model.schema.json beside the reader: what is written is valid, and both refuse the same changes of shape.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { describe, it } from "node:test";
import { Ajv2020 } from "ajv/dist/2020.js";
import { seldom } from "../../scripts/node-tests.mjs";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";

/** @typedef {null | boolean | number | string | Json[] | { [name: string]: Json }} Json */

const { Clip, Evaluation, Fold, Library, Model, TrainingSet } = builtPackage();
const isValid = new Ajv2020({ strict: false }).compile(read("docs/model.schema.json"));
/** What the schema refuses in a document; null: nothing. */
const schemaRefusal = (/** @type {Json} */ document) => (isValid(document) ? null : isValid.errors);

/** What the reader refuses in a document. */
function readerRefusal(/** @type {Json} */ document) {
  try {
    const { fromJson } = isObject(document) && document.kind === "library" ? Library : Model;
    fromJson(JSON.stringify(document)).free();
    return null;
  } catch (error) {
    return String(error);
  }
}

function read(/** @type {string} */ path) {
  return JSON.parse(readFileSync(at(path), "utf8"));
}

/** @returns {value is { [name: string]: Json }} */
function isObject(/** @type {Json} */ value) {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

const typeOf = (/** @type {Json} */ value) =>
  value === null ? "null" : Array.isArray(value) ? "array" : typeof value;

/**
 * All fields of a value, and the first two items of each list: the names on the way to it.
 * @returns {string[][]}
 */
function places(/** @type {Json} */ value) {
  if (typeof value !== "object" || value === null) return [[]];
  const fields = Object.entries(value).slice(0, Array.isArray(value) ? 2 : undefined);
  return [[], ...fields.flatMap(([name, field]) => places(field).map((rest) => [name, ...rest]))];
}

const valueAt = (/** @type {Json} */ document, /** @type {string[]} */ place) =>
  place.reduce((value, name) => /** @type {any} */ (value)[name], document);

/** The document with another value at a place. @returns {Json} */
function changedAt(
  /** @type {any} */ document,
  /** @type {string[]} */ [name, ...rest],
  /** @type {Json} */ other,
) {
  if (name === undefined) return other;
  const copy = Array.isArray(document) ? [...document] : { ...document };
  copy[name] = changedAt(document[name], rest, other);
  return copy;
}

/** Other values in the place of one. @returns {Json[]} */
function others(/** @type {Json} */ value) {
  const simple = [null, true, "x", 3, [], {}, -1, 0.5].filter(
    (other) => JSON.stringify(other) !== JSON.stringify(value),
  );
  if (!isObject(value)) return simple;
  const without = Object.keys(value).map((left) =>
    Object.fromEntries(Object.entries(value).filter(([name]) => name !== left)),
  );
  return [...simple, { ...value, unknown: 1 }, ...without];
}

const folder = "crate/vcgpdm/tests/library/documents";

describe("the schema of model files", () => {
  seldom.it("refuses what the reader refuses", () => {
    let [shapes, numbers] = [0, 0];
    for (const file of readdirSync(at(folder))) {
      const document = read(`${folder}/${file}`);
      assert.deepEqual([schemaRefusal(document), readerRefusal(document)], [null, null], file);
      for (const place of places(document)) {
        const value = valueAt(document, place);
        for (const other of others(value)) {
          const changed = changedAt(document, place, other);
          const [schema, reader] = [schemaRefusal(changed), readerRefusal(changed)];
          const where = `${file} at ${place.join("/")} with ${JSON.stringify(other)}: ${reader}`;
          assert.ok(schema === null || reader !== null, `the reader accepts ${where}`);
          // The others change only a number or a length.
          const isShape = typeOf(other) !== typeOf(value) || isObject(value);
          // The schema cannot check which joint is the root.
          if (isShape && place.at(-1) !== "parent") {
            assert.equal(schema === null, reader === null, where);
            shapes += Number(schema !== null);
          }
          numbers += Number(!isShape && schema !== null);
        }
      }
    }
    assert.ok(shapes > 5000 && numbers > 300, `${shapes} shapes and ${numbers} numbers were refused`);
  });

  it("accepts new models of every kind", () => {
    assert.equal(schemaRefusal(read("www/first/model.json")), null);
    const clips = new TrainingSet();
    for (const id of ["walk-1", "walk-2", "walk-3"]) clips.add(Clip.sample(id).cut(0, 60));
    const fold = new Fold(clips, { parts: "lower,upper" }, { heldOut: 1 });
    const size = { latent: 2, order: 2, dynamicsIps: 4, poseIps: 4, maxIterations: 3 };
    /** @type {import("vcgpdm").Candidate[]} */
    const candidates = [
      { model: "vgpdm", ...size },
      { model: "vgpdm", ...size, poseWeight: "balanced" },
      { model: "vcgpdm", ...size },
      { model: "vcgpdm", ...size, poseWeight: 0.1, uncoupled: true },
      { model: "map-gpdm", latent: 2, order: 2, maxIterations: 3, balanced: true, linear: true },
      { model: "map-cgpdm", latent: 2, order: 2, maxIterations: 3, balanced: true, linear: true },
      { model: "tmp", primitives: 2, normalisedTime: true },
      { model: "dmp-discrete", bases: 4 },
      { model: "dmp-rhythmic", bases: 4 },
    ];
    for (const candidate of candidates) {
      const training = new Evaluation(fold, candidate, 0);
      while (!training.step().done);
      const document = JSON.parse(training.model().toJson());
      assert.equal(schemaRefusal(document), null, candidate.model);
      document.provenance.note = "a note";
      document.sequences[1].rests_from = 0.5;
      assert.deepEqual([schemaRefusal(document), readerRefusal(document)], [null, null], candidate.model);
    }
  });
});
