// What a student has chosen, solved and written: kept in the browser, and saved as the files that a teacher collects.

const KEY = "matrixworld lesson";

/** A line of `predictions.jsonl`, as `predict` of the course writes it. */
interface Choice {
  readonly prediction: string;
  readonly choice: string;
  readonly time: string;
}

interface Kept {
  readonly choices: readonly Choice[];
  /** Exercise -> the last answer that was right. */
  readonly solved: Readonly<Record<string, string>>;
  readonly exit: string;
  /** Whether the answer to the exit question is done. */
  readonly done: boolean;
}

const NOTHING: Kept = { choices: [], solved: {}, exit: "", done: false };

/** It dispatches `choice` when a prediction is made. */
export class Store extends EventTarget {
  #kept: Kept;
  /** Whether the browser keeps what is written when the page is closed. */
  keeps = true;

  constructor() {
    super();
    this.#kept = this.#read();
    this.#write({});
  }

  /** Return the choice of a prediction; undefined if there is none yet. */
  choice = (name: string): string | undefined => this.#kept.choices.find(({ prediction }) => prediction === name)?.choice;

  choose(prediction: string, choice: string): void {
    const time = new Date().toISOString().replace(/\.\d+Z$/, "+00:00");
    this.#write({ choices: [...this.#kept.choices, { prediction, choice, time }] });
    this.dispatchEvent(new CustomEvent("choice", { detail: prediction }));
  }

  solved = (name: string): string | undefined => this.#kept.solved[name];
  solve = (name: string, answer: string): void => this.#write({ solved: { ...this.#kept.solved, [name]: answer } });

  get exit(): Pick<Kept, "exit" | "done"> {
    return this.#kept;
  }

  set exit(change: Partial<Pick<Kept, "exit" | "done">>) {
    this.#write(change);
  }

  get count(): number {
    return this.#kept.choices.length;
  }

  /** The text of `predictions.jsonl`. */
  get file(): string {
    return this.#kept.choices.map((each) => `${JSON.stringify(each)}\n`).join("");
  }

  forget(): void {
    this.#write(NOTHING);
  }

  #read(): Kept {
    try {
      return { ...NOTHING, ...(JSON.parse(localStorage.getItem(KEY) ?? "{}") as Partial<Kept>) };
    } catch {
      return NOTHING; // there is no storage, and `#write` notes it; or another program wrote there
    }
  }

  #write(change: Partial<Kept>): void {
    this.#kept = { ...this.#kept, ...change };
    try {
      localStorage.setItem(KEY, JSON.stringify(this.#kept));
    } catch {
      this.keeps = false; // the page says so
    }
  }
}
