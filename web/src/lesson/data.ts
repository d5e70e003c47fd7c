// What the page holds: the parts of docs/lesson.toml, and three races. `docs/make_pages.py` writes it.

import { text } from "../explorer/data.ts";
import type { Run } from "../explorer/data.ts";
import type { EvolveData } from "../evolve/data.ts";
import type { PageData } from "../playground/data.ts";

export interface Prediction {
  readonly predict: string;
  readonly question: string;
  /** Option -> its text. */
  readonly options: Readonly<Record<string, string>>;
  readonly outcome: string;
  readonly explanation?: string;
  /** What stands under the question instead of the outcome, which a second vote shows. */
  readonly later?: string;
  /** Of a second vote: the prediction that asked first. */
  readonly again?: string;
  /** A prediction without which it is not asked. */
  readonly needs?: string;
  readonly note?: string;
}

export interface Exercise {
  readonly exercise: string;
  readonly question: string;
  readonly explanation: string;
  /** The right number; exercises without one have a check of their own. */
  readonly answer?: number;
  readonly tolerance?: number;
  /** Wrong numbers, and what to say of them. */
  readonly clues?: readonly (readonly [number, string])[];
  readonly otherwise?: string;
  readonly matrix?: readonly (readonly number[])[];
}

/** A part that moves or takes an input; the other fields are its settings. */
export interface WidgetPart {
  readonly widget: string;
  /** A prediction of another section, without which it is not shown. */
  readonly needs?: string;
  readonly memories?: readonly number[];
  readonly memory?: number;
  readonly generations?: number;
  readonly shows?: "score" | "ones";
  /** Whether matrix and curve are shown while a race evolves. */
  readonly grows?: boolean;
  readonly hall?: boolean;
  readonly question?: string;
  readonly points?: readonly string[];
  readonly crossings?: readonly Crossing[];
}

/** Pursuers that mean to enter one free cell: rows down and columns to the right, and whether each may go. */
export interface Crossing {
  readonly title: string;
  readonly text: string;
  readonly ways: readonly (readonly [down: number, right: number, goes: boolean])[];
}

export type Part = { readonly text: string } | Prediction | Exercise | WidgetPart;

export interface Section {
  readonly id: string;
  readonly title: string;
  readonly minutes: number;
  readonly parts: readonly Part[];
}

export interface Lesson {
  readonly version: string;
  /**
   * Questions and letters of options are the same in one edition; files of different ones are not
   * counted together.
   */
  readonly edition: number;
  readonly title: string;
  readonly lead: string;
  readonly sections: readonly Section[];
  /** Races A, B and C. */
  readonly runs: readonly Run[];
  readonly playground: PageData;
  /** Of the races that evolve in the page. */
  readonly evolve: EvolveData;
}

export const isPrediction = (part: Part | undefined): part is Prediction =>
  part !== undefined && "predict" in part;

/** Return the predictions of a lesson by name, in its order. */
export const predictionsOf = ({ sections }: Pick<Lesson, "sections">): ReadonlyMap<string, Prediction> =>
  new Map(sections.flatMap(({ parts }) => parts.filter(isPrediction).map((part) => [part.predict, part])));

export const readLesson = (): Lesson => JSON.parse(text("data")) as Lesson;
