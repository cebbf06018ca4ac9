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
  #tables: readonly TableEntry[] = [];
  #parts: readonly TablePart[] = [];
  /** The columns of all parts. */
  #columns: readonly string[] = [];
  #clash = "";
  #refused = "";
  /** The columns that are left out of all tables, as the visitor wrote them. */
  #leftOut: readonly string[] = [];
  #leftOutProblem = "";
  #checks = 0;

  constructor(private readonly whole: WholeWorkers) {
    super();
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

  /** The names of the columns that are left out of all tables. */
  get leftOut(): readonly string[] {
    return this.#leftOut;
  }

  /** The reason why these columns could not be left out; empty after the next change. */
  get leftOutProblem(): string {
    return this.#leftOutProblem;
  }

  /** Leaves columns out of all tables, by names with commas between them. A name can begin or end with `*`. */
  async leaveOut(text: string): Promise<void> {
    const without = text
      .split(",")
      .map((name) => name.trim())
      .filter((name) => name !== "");
    const before = this.#tables;
    const read = async (table: TableEntry): Promise<TableEntry> => {
      const source = { ...table.source, without };
      return { ...table, ...(await this.whole.desk.run((worker) => worker.readTable(source))), source };
    };
    try {
      const tables = await Promise.all(before.map(read));
      // The visitor may have opened or removed a table meanwhile.
      if (this.#tables !== before) return this.leaveOut(text);
      [this.#tables, this.#leftOut, this.#leftOutProblem] = [tables, without, ""];
    } catch (problem) {
      this.#leftOutProblem = messageOf(problem);
    }
    await this.#changedTables();
  }

  /** Opens a file. If the same file is already open, nothing changes. */
  async open(file: File): Promise<void> {
    const source: TableSource = { name: file.name, file, without: [...this.#leftOut] };
    const read = await this.whole.desk.run((worker) => worker.readTable(source));
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
    // Other tables have other columns.
    if (this.#tables.length === 0) [this.#leftOut, this.#leftOutProblem] = [[], ""];
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
        : await this.whole.desk.run((worker) => worker.checkTables(sources)).catch(messageOf);
    // The visitor may have ticked other tables during the check.
    if (check !== this.#checks) return;
    this.#clash = clash;
    this.changed();
  }
}
