// The open tables, each of which is a trial: the tables for training, and the parts of their columns.
import type { WholeWorkers } from "../engine/whole-workers";
import type { ReadTable, TablePart, TableSource } from "../engine/series-protocol";
import { messageOf } from "../ui/format";
import { renamed, nameProblem } from "../clips/part-names";
import { Store } from "../ui/store";
import { added, moved, partsByName, without } from "./parts-of-columns";

export interface TableEntry extends ReadTable {
  source: TableSource;
  /** Whether the training uses the table. */
  ticked: boolean;
}

export class TablesStore extends Store {
  readonly #whole: WholeWorkers;
  #tables: readonly TableEntry[] = [];
  #parts: readonly TablePart[] = [];
  /** The columns of all parts. */
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

  /** The columns of the ticked tables, in the order of the first ticked table. */
  get columns(): readonly string[] {
    return this.#columns;
  }

  /** All parts, including parts without columns. */
  get parts(): readonly TablePart[] {
    return this.#parts;
  }

  /** The reason why the ticked tables cannot be trained on together; empty if they can. */
  get clash(): string {
    return this.#clash;
  }

  /** The reason why the last new name of a part was refused; empty after the next change. */
  get refused(): string {
    return this.#refused;
  }

  /** Opens a file. If the same file is already open, nothing changes. */
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

  /** Renames a part if no other part has the name. Returns the current name of the part. */
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

  /** New columns get new parts. The ticked tables are checked again. */
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
    // The visitor may have ticked other tables during the check.
    if (check !== this.#checks) return;
    this.#clash = clash;
    this.changed();
  }
}
