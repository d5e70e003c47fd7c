// What the page holds: the parts of docs/lesson.toml, and three races. `docs/make_pages.py` writes it.

import { text } from "../explorer/data.ts";
import type { Run } from "../explorer/data.ts";
import type { PageData } from "../playground/data.ts";

export interface Prediction {
  readonly predict: string;
  readonly question: string;
  /** Option -> its text. */
  readonly options: Readonly<Record<string, string>>;
  readonly outcome: string;
  readonly explanation: string;
  /** What stands under the question instead of the outcome, which a later part shows. */
  readonly later?: string;
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

/** The outcome of an earlier prediction. */
export interface Outcome {
  readonly outcome: string;
}

export type Part = { readonly text: string } | Prediction | Exercise | WidgetPart | Outcome;

export interface Section {
  readonly id: string;
  readonly title: string;
  readonly minutes: number;
  readonly parts: readonly Part[];
}

export interface Lesson {
  readonly version: string;
  readonly title: string;
  readonly lead: string;
  readonly sections: readonly Section[];
  /** Races A, B and C. */
  readonly runs: readonly Run[];
  readonly playground: PageData;
}

export const readLesson = (): Lesson => JSON.parse(text("data")) as Lesson;
