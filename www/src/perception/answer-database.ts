// The answers of a graphics Turing test in a database of their own, a record for each row: a tab that is
// closed loses none.
import { openDB } from "idb";
import { type AnswerDatabase, answered, type Participation, type Row } from "./participation";
import { type Check, has, isBoolean, isNumber, isText } from "../ui/checks";

const PARTICIPATIONS = "participations";
const ROWS = "rows";
const STUDIES = "studies";
const LOCK_PREFIX = "vcgpdm answers ";

/** Participations of the same study share the record of the study, which has this number. */
type Stored = Participation & { studyNumber: number };

const isStored: Check = has({
  key: isText,
  at: isNumber,
  participant: isText,
  seed: isNumber,
  study: isText,
  title: isText,
  trials: isNumber,
  simulated: isBoolean,
  studyNumber: isNumber,
});

const rowsOf = (key: string) => IDBKeyRange.bound([key], [key, []]);

/** The participations that are under way, in this tab or in others. */
async function underWay(): Promise<string[]> {
  const { held = [] } = (await navigator.locks?.query()) ?? {};
  return held.flatMap(({ name }) => (name?.startsWith(LOCK_PREFIX) ? [name.slice(LOCK_PREFIX.length)] : []));
}

/** How many participants and answers "Forget everything" would remove. */
export interface AnswerCounts {
  participants: number;
  answers: number;
}

interface ForgettableAnswers {
  countForgettable(): Promise<AnswerCounts>;
  /** Removes all participations but those under way. The result writes them back. */
  forgetAll(): Promise<() => Promise<void>>;
}

/** Fails when the browser stores nothing. */
export async function answerDatabase(): Promise<AnswerDatabase & ForgettableAnswers> {
  const database = await openDB("vcgpdm answers", 1, {
    upgrade(fresh) {
      for (const store of [PARTICIPATIONS, ROWS]) fresh.createObjectStore(store);
      fresh.createObjectStore(STUDIES, { autoIncrement: true });
    },
    // Another tab wants to change the database: this tab closes its connection and stores nothing more.
    blocking: (_, __, event) => (event.target as IDBDatabase).close(),
  });
  const participations = async () =>
    ((await database.getAll(PARTICIPATIONS)) as unknown[]).filter((record): record is Stored =>
      isStored(record),
    );
  const write = () => database.transaction([PARTICIPATIONS, ROWS, STUDIES], "readwrite");
  const all = async () => {
    const found = await participations();
    const reading = database.transaction(ROWS);
    const rows = await Promise.all(
      found.map(({ key }) => reading.store.getAll(rowsOf(key)) as Promise<unknown[]>),
    );
    return found.map(({ studyNumber: _, ...participation }, i) => ({
      ...participation,
      rows: (rows[i] ?? []).filter((row): row is Row => has({})(row)),
    }));
  };
  return {
    all,
    async study(key) {
      const { studyNumber } = ((await database.get(PARTICIPATIONS, key)) as Stored | undefined) ?? {};
      if (studyNumber === undefined) return null;
      return ((await database.get(STUDIES, studyNumber)) as string | undefined) ?? null;
    },
    async begin(participation, study) {
      const writing = write();
      const studies = writing.objectStore(STUDIES);
      const [texts, numbers] = await Promise.all([
        studies.getAll() as Promise<string[]>,
        studies.getAllKeys(),
      ]);
      const studyNumber = Number(numbers[texts.indexOf(study)] ?? (await studies.add(study)));
      const stored: Stored = { ...participation, studyNumber };
      await Promise.all([writing.objectStore(PARTICIPATIONS).put(stored, participation.key), writing.done]);
    },
    async add(key, place, row) {
      await database.put(ROWS, row, [key, place]);
    },
    async forget(key) {
      const all = await participations();
      const number = all.find((stored) => stored.key === key)?.studyNumber;
      const isShared = all.some((stored) => stored.key !== key && stored.studyNumber === number);
      const writing = write();
      await Promise.all([
        writing.objectStore(PARTICIPATIONS).delete(key),
        writing.objectStore(ROWS).delete(rowsOf(key)),
        number === undefined || isShared ? undefined : writing.objectStore(STUDIES).delete(number),
        writing.done,
      ]);
    },
    hold: (key) =>
      new Promise((resolve) => {
        // Without locks nothing tells tabs apart.
        if (!navigator.locks) resolve(() => {});
        else
          void navigator.locks.request(LOCK_PREFIX + key, { ifAvailable: true }, (lock) => {
            if (lock) return new Promise<void>((release) => resolve(release));
            resolve(null);
            return undefined;
          });
      }),
    async countForgettable() {
      const staying = await underWay();
      const leaving = (await all()).filter(({ key }) => !staying.includes(key));
      const answers = leaving.reduce((sum, participation) => sum + answered(participation), 0);
      return { participants: leaving.length, answers };
    },
    async forgetAll() {
      const staying = await underWay();
      const studyNumbers = (await participations())
        .filter(({ key }) => staying.includes(key))
        .map(({ studyNumber }) => studyNumber);
      const removed: { name: string; key: IDBValidKey; value: unknown }[] = [];
      const writing = write();
      const removeBut = async (name: string, stays: (key: unknown) => boolean) => {
        const store = writing.objectStore(name);
        for (const key of await store.getAllKeys()) {
          if (stays(key)) continue;
          removed.push({ name, key, value: await store.get(key) });
          await store.delete(key);
        }
      };
      await removeBut(PARTICIPATIONS, (key) => staying.some((stays) => stays === key));
      await removeBut(ROWS, (key) => Array.isArray(key) && staying.includes(key[0]));
      await removeBut(STUDIES, (key) => studyNumbers.some((number) => number === key));
      await writing.done;
      return async () => {
        const writing = write();
        await Promise.all([
          ...removed.map(({ name, key, value }) => writing.objectStore(name).put(value, key)),
          writing.done,
        ]);
      };
    },
  };
}
