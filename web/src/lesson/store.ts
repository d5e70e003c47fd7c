// What a student has chosen, solved and written: kept in the browser, and saved as the files that a
// teacher collects.

/** A line of `predictions.jsonl`, as `predict` of the course writes it; the lesson adds the pupil. */
interface Choice {
  readonly prediction: string;
  readonly choice: string;
  readonly time: string;
}

interface Kept {
  /** A random number: files that are saved in one browser are of one pupil. */
  readonly pupil: string;
  readonly choices: readonly Choice[];
  /** Exercise -> the last answer that was right. */
  readonly solved: Readonly<Record<string, string>>;
  readonly exit: string;
  /** Whether the answer to the exit question is done. */
  readonly done: boolean;
}

const nothing = (): Kept => {
  const [number] = crypto.getRandomValues(new Uint32Array(1));
  return { pupil: number!.toString(16).padStart(8, "0"), choices: [], solved: {}, exit: "", done: false };
};

/** It dispatches `choice` when a prediction is made. */
export class Store extends EventTarget {
  #kept: Kept;
  readonly #edition: number;
  readonly #key: string;
  /** Whether the browser keeps what is written when the page is closed. */
  keeps = true;

  constructor(edition: number) {
    super();
    this.#edition = edition;
    this.#key = `matrixworld lesson ${edition}`;
    this.#kept = this.#read();
    this.#write({});
  }

  /** Return the choice of a prediction; undefined if there is none yet. */
  choice = (name: string): string | undefined =>
    this.#kept.choices.find(({ prediction }) => prediction === name)?.choice;

  choose(prediction: string, choice: string): void {
    const time = new Date().toISOString().replace(/\.\d+Z$/, "+00:00");
    this.#write({ choices: [...this.#kept.choices, { prediction, choice, time }] });
    this.dispatchEvent(new CustomEvent("choice", { detail: prediction }));
  }

  solved = (name: string): string | undefined => this.#kept.solved[name];
  solve = (name: string, answer: string): void =>
    this.#write({ solved: { ...this.#kept.solved, [name]: answer } });

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
    const { choices, pupil } = this.#kept;
    return choices.map((each) => `${JSON.stringify({ ...each, edition: this.#edition, pupil })}\n`).join("");
  }

  forget = (): void => this.#write(nothing());

  #read(): Kept {
    try {
      return { ...nothing(), ...(JSON.parse(localStorage.getItem(this.#key) ?? "{}") as Partial<Kept>) };
    } catch {
      return nothing(); // there is no storage, and `#write` notes it; or another program wrote there
    }
  }

  #write(change: Partial<Kept>): void {
    this.#kept = { ...this.#kept, ...change };
    try {
      localStorage.setItem(this.#key, JSON.stringify(this.#kept));
    } catch {
      this.keeps = false; // the page says so
    }
  }
}
