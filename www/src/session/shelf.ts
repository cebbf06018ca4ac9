// Where visits are kept: the browser's own database. Each visit has records under names.
import { openDB } from "idb";

export interface Shelf {
  /** The names of the visits that are kept. */
  visits(): Promise<string[]>;
  /** The records of a visit, by their names. */
  read(visit: string): Promise<Map<string, unknown>>;
  /** Writes records, all or none; those that are undefined are removed. Fails where there is no room. */
  write(visit: string, records: ReadonlyMap<string, unknown>): Promise<void>;
  forget(visit: string): Promise<void>;
}

const RECORDS = "records";

const all = (visit: string) => IDBKeyRange.bound([visit], [visit, []]);

export async function browserShelf(): Promise<Shelf> {
  const database = await openDB("vcgpdm", 1, {
    upgrade: (fresh) => void fresh.createObjectStore(RECORDS),
    // Another tab wants to change the database: this one lets go, and keeps no more.
    blocking: (_, __, event) => (event.target as IDBDatabase).close(),
  });
  return {
    async visits() {
      const keys = (await database.getAllKeys(RECORDS)) as [string, string][];
      return [...new Set(keys.map(([visit]) => visit))];
    },
    async read(visit) {
      const reading = database.transaction(RECORDS);
      const [keys, values] = await Promise.all([
        reading.store.getAllKeys(all(visit)) as Promise<[string, string][]>,
        reading.store.getAll(all(visit)) as Promise<unknown[]>,
      ]);
      return new Map(keys.map(([, name], i) => [name, values[i]]));
    },
    async write(visit, records) {
      const writing = database.transaction(RECORDS, "readwrite");
      const asked = [...records].map(([name, value]) =>
        value === undefined ? writing.store.delete([visit, name]) : writing.store.put(value, [visit, name]),
      );
      await Promise.all([...asked, writing.done]);
    },
    forget: (visit) => database.delete(RECORDS, all(visit)),
  };
}
