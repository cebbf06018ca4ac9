// Tables that the visitor has opened, a trial each: which of them are trained on, and which columns are which
// part's.
import type { WholeWorkers } from "../engine/whole-workers";
import type { ReadTable, TablePart, TableSource } from "../engine/series-protocol";
import { messageOf } from "../ui/format";
import { renamed, nameProblem } from "../ui/part-names";
import { Store } from "../ui/store";
import { added, moved, partsByName, without } from "./parts-of-columns";

export interface TableEntry extends ReadTable {
  source: TableSource;
  /** Whether it is trained on. */
  ticked: boolean;
}

export class TablesStore extends Store {
  readonly #whole: WholeWorkers;
  #tables: readonly TableEntry[] = [];
  #parts: readonly TablePart[] = [];
  /** The columns that the parts are of. */
  #columns: readonly string[] = [];
  #clash = "";
  #refused = "";
  #checks = 0;

  constructor(whole: WholeWorkers) {
    super();
    this.#whole = whole;
  }

  get all(): readonly TableEntry[] {
    return this.#tables;
  }

  get ticked(): readonly TableEntry[] {
    return this.#tables.filter(({ ticked }) => ticked);
  }

  /** The columns of the tables that are trained on, in the order of the first of them. */
  get columns(): readonly string[] {
    return this.#columns;
  }

  /** All parts, also those that have no column yet. */
  get parts(): readonly TablePart[] {
    return this.#parts;
  }

  /** Why the ticked tables cannot be trained on together; empty when they can. */
  get clash(): string {
    return this.#clash;
  }

  /** Why the last name of a part was refused; empty after the next change. */
  get refused(): string {
    return this.#refused;
  }

  /** Opens a file; one that is open already stays as it is. */
  async open(file: File): Promise<void> {
    const source: TableSource = { name: file.name, file };
    const read = await this.#whole.desk.run((worker) => worker.readTable(source));
    if (this.#tables.some(({ info }) => info.sha256 === read.info.sha256)) return;
    this.#tables = [...this.#tables, { ...read, source, ticked: true }];
    await this.#changedTables();
  }

  async tick(table: TableEntry, ticked: boolean): Promise<void> {
    this.#tables = this.#tables.map((other) => (other === table ? { ...other, ticked } : other));
    await this.#changedTables();
  }

  async remove(table: TableEntry): Promise<void> {
    this.#tables = this.#tables.filter((other) => other !== table);
    await this.#changedTables();
  }

  moveColumn(column: string, part: number): void {
    this.#setParts(moved(this.#parts, this.#columns, column, part));
  }

  addPart(): void {
    this.#setParts(added(this.#parts));
  }

  removePart(part: number): void {
    this.#setParts(without(this.#parts, this.#columns, part));
  }

  /** Gives a part another name, if it is one that no other part has. Answers the name that it has now. */
  renamePart(part: number, text: string): string {
    const name = text.trim();
    const why = nameProblem(this.#parts, part, name);
    this.#setParts(why ? this.#parts : renamed(this.#parts, part, name), why);
    return this.#parts[part]?.name ?? "";
  }

  #setParts(parts: readonly TablePart[], refused = ""): void {
    this.#parts = parts;
    this.#refused = refused;
    this.changed();
  }

  /** Other columns have other parts; and other tables may not go together. */
  async #changedTables(): Promise<void> {
    const columns = this.ticked[0]?.info.columns ?? [];
    if (JSON.stringify([...columns].sort()) !== JSON.stringify([...this.#columns].sort()))
      this.#parts = partsByName(columns);
    this.#columns = columns;
    this.#refused = "";
    this.changed();
    this.#checks += 1;
    const check = this.#checks;
    const sources = this.ticked.map(({ source }) => source);
    const clash =
      sources.length < 2
        ? ""
        : await this.#whole.desk.run((worker) => worker.checkTables(sources)).catch(messageOf);
    // Others may have been ticked meanwhile.
    if (check !== this.#checks) return;
    this.#clash = clash;
    this.changed();
  }
}
