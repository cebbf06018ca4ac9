// The browser's database of visits. Each visit has records under names.
import { openDB } from "idb";

export interface VisitDatabase {
  /** The names of the stored visits. */
  visits(): Promise<string[]>;
  /** The records of a visit, by their names; those of files are empty without `withFiles`. */
  read(visit: string, withFiles: boolean): Promise<Map<string, unknown>>;
  /** Writes all records or none; those that are undefined are removed. Fails when the storage is full. */
  write(visit: string, records: ReadonlyMap<string, unknown>): Promise<void>;
  forget(visit: string): Promise<void>;
  /** Removes everything but the records of these visits, and returns the removed records. */
  forgetAllBut(visits: readonly string[]): Promise<RemovedRecords>;
  /** Writes removed records back, all or none. */
  restore(removed: RemovedRecords): Promise<void>;
}

/** Records with their keys. */
export type RemovedRecords = readonly (readonly [key: IDBValidKey, value: unknown])[];

const RECORDS = "records";

const allOf = (visit: string) => IDBKeyRange.bound([visit], [visit, []]);

/** Splits a key of ours; another program or version may have written others. */
function nameOf(key: IDBValidKey): [visit: string, name: string] | null {
  if (!Array.isArray(key)) return null;
  const [visit, name] = key;
  return key.length === 2 && typeof visit === "string" && typeof name === "string" ? [visit, name] : null;
}

export async function browserDatabase(): Promise<VisitDatabase> {
  const database = await openDB("vcgpdm", 1, {
    upgrade: (fresh) => void fresh.createObjectStore(RECORDS),
    // Another tab wants to change the database: this tab closes its connection and stores nothing more.
    blocking: (_, __, event) => (event.target as IDBDatabase).close(),
  });
  return {
    async visits() {
      const keys = await database.getAllKeys(RECORDS);
      return [...new Set(keys.flatMap((key) => nameOf(key)?.[0] ?? []))];
    },
    async read(visit, withFiles) {
      const { store } = database.transaction(RECORDS);
      const names = (await store.getAllKeys(allOf(visit))).flatMap((key) => nameOf(key)?.[1] ?? []);
      const records = names.map(async (name): Promise<[string, unknown]> => {
        // Files fill the memory.
        if (name.startsWith("file ") && !withFiles) return [name, new Blob()];
        const value: unknown = await store.get([visit, name]);
        return [name, value instanceof ArrayBuffer ? new Blob([value]) : value];
      });
      return new Map(await Promise.all(records));
    },
    async write(visit, records) {
      // WebKit stores no blob in a private window.
      const plain = await Promise.all(
        [...records].map(async ([name, value]) => ({
          name,
          value: value instanceof Blob ? await value.arrayBuffer() : value,
        })),
      );
      const writing = database.transaction(RECORDS, "readwrite");
      const requests = plain.map(({ name, value }) =>
        value === undefined ? writing.store.delete([visit, name]) : writing.store.put(value, [visit, name]),
      );
      await Promise.all([...requests, writing.done]);
    },
    forget: (visit) => database.delete(RECORDS, allOf(visit)),
    async forgetAllBut(visits) {
      const writing = database.transaction(RECORDS, "readwrite");
      const keys = await writing.store.getAllKeys();
      const leaving = keys.filter((key) => !visits.includes(nameOf(key)?.[0] ?? ""));
      const removed = await Promise.all(
        leaving.map(async (key) => [key, (await writing.store.get(key)) as unknown] as const),
      );
      await Promise.all([...leaving.map((key) => writing.store.delete(key)), writing.done]);
      return removed;
    },
    async restore(removed) {
      const writing = database.transaction(RECORDS, "readwrite");
      await Promise.all([...removed.map(([key, value]) => writing.store.put(value, key)), writing.done]);
    },
  };
}
