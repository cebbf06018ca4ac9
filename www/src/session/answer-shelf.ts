// Where the answers of a graphics Turing test are kept: a database of their own in the browser, a record for
// each row, so that a tab that is closed loses none.
import { openDB } from "idb";
import type { AnswerShelf, Participation, Row } from "../perception/participation";

const PARTICIPATIONS = "participations";
const ROWS = "rows";
const STUDIES = "studies";

/** A participation, and under which number its study is kept: participations of the same study share it. */
type Kept = Participation & { studyNumber: number };

const rowsOf = (key: string) => IDBKeyRange.bound([key], [key, []]);

/** Fails where the browser keeps nothing. */
export async function answerShelf(): Promise<AnswerShelf & { forgetAll(): Promise<void> }> {
  const database = await openDB("vcgpdm answers", 1, {
    upgrade(fresh) {
      for (const store of [PARTICIPATIONS, ROWS]) fresh.createObjectStore(store);
      fresh.createObjectStore(STUDIES, { autoIncrement: true });
    },
    // Another tab wants to change the database: this one lets go, and keeps no more.
    blocking: (_, __, event) => (event.target as IDBDatabase).close(),
  });
  return {
    async all() {
      const found = (await database.getAll(PARTICIPATIONS)) as Kept[];
      const reading = database.transaction(ROWS);
      const rows = await Promise.all(
        found.map(({ key }) => reading.store.getAll(rowsOf(key)) as Promise<Row[]>),
      );
      return found.map(({ studyNumber: _, ...participation }, i) => ({
        ...participation,
        rows: rows[i] ?? [],
      }));
    },
    async study(key) {
      const { studyNumber } = ((await database.get(PARTICIPATIONS, key)) as Kept | undefined) ?? {};
      if (studyNumber === undefined) return null;
      return ((await database.get(STUDIES, studyNumber)) as string | undefined) ?? null;
    },
    async begin(participation, study) {
      const writing = database.transaction([PARTICIPATIONS, STUDIES], "readwrite");
      const studies = writing.objectStore(STUDIES);
      const [texts, numbers] = await Promise.all([
        studies.getAll() as Promise<string[]>,
        studies.getAllKeys(),
      ]);
      const known = numbers[texts.indexOf(study)];
      const studyNumber = Number(known ?? (await studies.add(study)));
      const kept: Kept = { ...participation, studyNumber };
      await Promise.all([writing.objectStore(PARTICIPATIONS).put(kept, participation.key), writing.done]);
    },
    async add(key, place, row) {
      await database.put(ROWS, row, [key, place]);
    },
    async forget(key) {
      const all = (await database.getAll(PARTICIPATIONS)) as Kept[];
      const number = all.find((kept) => kept.key === key)?.studyNumber;
      const others = all.some((kept) => kept.key !== key && kept.studyNumber === number);
      const writing = database.transaction([PARTICIPATIONS, ROWS, STUDIES], "readwrite");
      await Promise.all([
        writing.objectStore(PARTICIPATIONS).delete(key),
        writing.objectStore(ROWS).delete(rowsOf(key)),
        number === undefined || others ? undefined : writing.objectStore(STUDIES).delete(number),
        writing.done,
      ]);
    },
    hold: (key) =>
      new Promise((held) => {
        // Without locks nothing tells tabs apart.
        if (!navigator.locks) held(() => {});
        else
          void navigator.locks.request(`vcgpdm answers ${key}`, { ifAvailable: true }, (lock) => {
            if (lock) return new Promise<void>((release) => held(release));
            held(null);
            return undefined;
          });
      }),
    async forgetAll() {
      const writing = database.transaction([PARTICIPATIONS, ROWS, STUDIES], "readwrite");
      await Promise.all([
        ...[PARTICIPATIONS, ROWS, STUDIES].map((store) => writing.objectStore(store).clear()),
        writing.done,
      ]);
    },
  };
}
