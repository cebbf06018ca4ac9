import { beforeEach, describe, expect, it } from "vitest";
import { progress } from "../engine/engine.fake";
import type { ClipEntry } from "../clips/clips-store";
import { armsText, libraryText } from "../engine/library.fake";
import type { Imported } from "../engine/library-protocol";
import type { TrainingReport } from "../engine/protocol";
import { FakeProgram, settled } from "../engine/whole-workers.fake";
import { NoticesStore } from "../ui/notices-store";
import { ImportStore } from "./import-store";
import { LibraryStore } from "./library-store";

const clip = { key: "a", loaded: { id: 7 }, source: { sample: "walk-1" }, first: 5, end: 90 };
const MISFIT = { reason: "the pose maps of upper differ", canBeRelearned: true };

let program: FakeProgram;
let library: LibraryStore;
let imports: ImportStore;
beforeEach(async () => {
  program = new FakeProgram();
  library = new LibraryStore(program, new NoticesStore(), async () => libraryText("first"));
  imports = new ImportStore(program, { all: [clip] as unknown as ClipEntry[] }, library);
  await library.openFirst();
});

async function end(found: Imported | null): Promise<void> {
  await settled();
  const training = program.libraries.imports.at(-1);
  training?.report({
    progress: { ...progress(9), fraction: 1 },
    elapsed: 1.5,
    found,
  } as TrainingReport<Imported>);
  training?.end({ cancelled: false, reason: "settled" });
}

describe("primitives of another file", () => {
  it("are added where they fit, and only once", async () => {
    await imports.openFile(armsText("swing"), "swing.json");
    expect(imports.text).toBe("Added arms: swing.");
    expect(library.current?.info.primitives.map(({ name }) => name)).toEqual([
      "walk",
      "wave",
      "walk",
      "wave",
      "swing",
    ]);
    expect(library.current?.unsaved).toBe(true);
    expect(library.stored?.text).toBe(libraryText("first", [], ["swing"]));
    expect(program.libraries.walks).toHaveLength(1);
    await settled();
    expect(library.motionOf([0, 4])?.frames).toBe(120);
    await imports.add(armsText("swing"), "swing.json");
    expect(imports.text).toBe("These primitives are in the library already.");
  });

  it("of a whole body are opened as a library", async () => {
    expect(library.stored).toBeNull();
    await imports.openFile(libraryText("second"), "second.json");
    expect(library.current?.title).toBe("second.json");
    expect(library.stored).toMatchObject({ title: "second.json", unsaved: false });
  });

  it("that do not fit are offered to be learned again", async () => {
    program.libraries.misfit = MISFIT;
    await imports.add(armsText("swing"), "swing.json");
    expect(imports.offer).toEqual({ title: "swing.json", text: armsText("swing"), misfit: MISFIT });
    expect(library.current?.unsaved).toBe(false);
    const learned = imports.relearn("a", 3);
    await settled();
    await expect(imports.add(armsText("other"), "other.json")).rejects.toThrow("being learned again");
    await end({ text: libraryText("first", [], ["swing"]), lost: [0.01, 0.25] });
    await learned;
    expect(program.libraries.imports[0]?.job).toMatchObject({
      library: libraryText("first"),
      other: armsText("swing"),
      clips: [{ id: 7, first: 5, end: 90 }],
      seed: 3,
    });
    expect(imports.text).toBe(
      "Added arms: swing. The pose maps of this library do not show 1.0 % of lower and 25.0 % of upper.",
    );
    expect(imports.offer).toBeNull();
    expect(library.current?.info.primitives).toHaveLength(5);
  });

  it("are learned from the data of their file without a clip, and an offer can be declined", async () => {
    program.libraries.misfit = MISFIT;
    await imports.add(armsText("swing"), "swing.json");
    const learned = imports.relearn("", 1);
    await settled();
    expect(program.libraries.imports[0]?.job.clips).toEqual([]);
    imports.dismiss();
    expect(imports.offer).not.toBeNull();
    imports.cancel();
    await learned;
    imports.dismiss();
    expect(imports.offer).toBeNull();
    expect(library.current?.info.primitives).toHaveLength(4);
  });

  it("of another body are refused", async () => {
    program.libraries.misfit = { reason: "the skeletons differ", canBeRelearned: false };
    await imports.add(armsText("swing"), "swing.json");
    await imports.relearn("", 1);
    expect(program.libraries.imports).toEqual([]);
  });
});
