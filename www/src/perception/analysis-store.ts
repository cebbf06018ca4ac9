// The analysis of answers: the files of participants, and the results that the library computes from them.
import type { WholeWorkers } from "../engine/whole-workers";
import type { AnswersFile, PerceptionResults } from "../engine/whole-protocol";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";

export class AnalysisStore extends Store {
  #files: readonly AnswersFile[] = [];
  #results: PerceptionResults | null = null;
  #busy = false;
  #problem = "";
  /** The number of the newest request; results of older ones are dropped. */
  #asked = 0;

  constructor(private readonly whole: WholeWorkers) {
    super();
  }

  /** The files that are analysed together. */
  get files(): readonly AnswersFile[] {
    return this.#files;
  }

  get results(): PerceptionResults | null {
    return this.#results;
  }

  get busy(): boolean {
    return this.#busy;
  }

  /** Why the files could not be analysed. */
  get problem(): string {
    return this.#problem;
  }

  /** Adds files to the analysis; a file replaces one of the same name. */
  add(study: string, files: readonly AnswersFile[]): Promise<void> {
    const names = new Set(files.map(({ name }) => name));
    return this.analyse(study, [...this.#files.filter(({ name }) => !names.has(name)), ...files]);
  }

  remove(study: string, name: string): Promise<void> {
    return this.analyse(
      study,
      this.#files.filter((file) => file.name !== name),
    );
  }

  /** The results as JSON, equal to the file of the terminal program. */
  json(study: string): Promise<string> {
    return this.whole.desk.run((worker) => worker.perceptionJson(study, [...this.#files]));
  }

  /** Analyses only these files. */
  async analyse(study: string, files: readonly AnswersFile[]): Promise<void> {
    this.#asked += 1;
    const asked = this.#asked;
    [this.#files, this.#busy, this.#problem] = [files, files.length > 0, ""];
    if (files.length === 0) this.#results = null;
    this.changed();
    if (files.length === 0) return;
    let found: PerceptionResults | null = null;
    let problem = "";
    try {
      found = await this.whole.desk.run((worker) => worker.analysePerception(study, [...files]));
    } catch (failure) {
      problem = messageOf(failure);
    }
    if (asked !== this.#asked) return;
    [this.#results, this.#problem, this.#busy] = [found, problem, false];
    this.changed();
  }
}
