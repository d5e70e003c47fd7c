// The votes of a class, from the files that pupils have saved. The rule for doubles is that of
// `count_votes` in tutorials/course/votes.py: of each pupil a prediction counts once.

import type { Prediction } from "./data.ts";

/** Most bytes of a file, as the class tournament has it: the predictions of a lesson have 1 kB. */
export const MOST_BYTES = 2 ** 16;

export interface SavedFile {
  readonly name: string;
  /** Null if there are more than `MOST_BYTES`. */
  readonly text: string | null;
}

export interface Votes {
  /** How many pupils made each choice, by prediction and option. */
  readonly counts: ReadonlyMap<string, ReadonlyMap<string, number>>;
  readonly pupils: number;
  /** Files that are not counted, and why. */
  readonly left: readonly { readonly file: string; readonly reason: string }[];
}

/** What a lesson asks: its edition, and its predictions by name. */
export interface Asked {
  readonly edition: number;
  readonly predictions: ReadonlyMap<string, Pick<Prediction, "options">>;
}

interface Choices {
  readonly pupil: string;
  readonly choices: ReadonlyMap<string, string>;
}

/** Count the first choice of each pupil for each prediction. */
export function countVotes(files: readonly SavedFile[], asked: Asked): Votes {
  const left: { file: string; reason: string }[] = [];
  const read: (Choices & SavedFile)[] = [];
  for (const file of files) {
    try {
      read.push({ ...file, ...choicesOf(file.text, asked) });
    } catch (error) {
      left.push({ file: file.name, reason: (error as Error).message });
    }
  }
  const counts = new Map(
    [...asked.predictions].map(([name, { options }]) => [
      name,
      new Map(Object.keys(options).map((option) => [option, 0])),
    ]),
  );
  const counted = new Map<string, string>(); // pupil and prediction -> the file
  const texts = new Map<string | null, string>();
  // A pupil who saves again saves more: the longest file first.
  for (const { name: file, text, pupil, choices } of read.sort((a, b) => b.choices.size - a.choices.size)) {
    const fresh = [...choices].filter(([name]) => !counted.has(`${pupil} ${name}`));
    const other =
      texts.get(text) ?? (fresh.length ? undefined : counted.get(`${pupil} ${[...choices.keys()][0]}`));
    if (other !== undefined) {
      left.push({
        file,
        reason: texts.has(text) ? `double: the same content as ${other}` : `double: the pupil of ${other}`,
      });
      continue;
    }
    texts.set(text, file);
    for (const [name, choice] of fresh) {
      counted.set(`${pupil} ${name}`, file);
      counts.get(name)!.set(choice, counts.get(name)!.get(choice)! + 1);
    }
  }
  return { counts, pupils: new Set([...counted.keys()].map((each) => each.split(" ")[0])).size, left };
}

/** Return the first choice of each prediction; an error says what is wrong with the text. */
function choicesOf(text: string | null, { edition, predictions }: Asked): Choices {
  if (text === null) throw new Error(`expected at most ${MOST_BYTES} bytes`);
  const choices = new Map<string, string>();
  let pupil = "";
  const lines = text.split(/\r?\n/).filter((line) => line.trim());
  if (!lines.length) throw new Error("expected predictions that the lesson has saved, got an empty file");
  lines.forEach((line, at) => {
    const entry = parsed(line);
    const { prediction: name, choice } = entry;
    if (typeof name !== "string" || typeof choice !== "string") {
      throw new Error(`line ${at + 1}: expected a prediction and its choice`);
    }
    if (entry["edition"] !== edition) {
      throw new Error(
        `line ${at + 1}: expected edition ${edition} of the course, got ${told(entry["edition"])}`,
      );
    }
    const options = predictions.get(name)?.options;
    if (!options) throw new Error(`line ${at + 1}: expected a prediction of the lesson, got ${told(name)}`);
    if (!Object.hasOwn(options, choice)) {
      throw new Error(
        `line ${at + 1}: expected one of ${Object.keys(options).join(", ")} for ${name}, got ${told(choice)}`,
      );
    }
    pupil ||= String(entry["pupil"] ?? "");
    if (!/^[0-9a-f]{8}$/.test(pupil) || entry["pupil"] !== pupil) {
      throw new Error(`line ${at + 1}: expected lines of one pupil`);
    }
    if (!choices.has(name)) choices.set(name, choice);
  });
  return { pupil, choices };
}

function parsed(line: string): Readonly<Record<string, unknown>> {
  try {
    const entry: unknown = JSON.parse(line);
    return typeof entry === "object" && entry !== null ? (entry as Record<string, unknown>) : {};
  } catch {
    return {}; // a line without a prediction, which is told
  }
}

/** Return a value as a short text; earlier editions wrote none. */
const told = (value: unknown): string => (value === undefined ? "none" : JSON.stringify(value).slice(0, 40));
