// What the page holds of a class tournament; results.py writes it.

import type { Team } from "../../../web/src/engine/teams.ts";
import type { WorldConfig } from "../../../web/src/engine/types.ts";
import type { Matrix } from "../../../web/src/explorer/data.ts";
import { text } from "../../../web/src/explorer/data.ts";

/** One row of a table of standings. */
export interface Standing {
  readonly name: string;
  readonly kind: "program" | "genome" | "script";
  readonly file: string;
  /** Its row of the matrix, or its column. */
  readonly number: number;
  /** A rank or a range of ranks; empty for a script. */
  readonly rank: string;
  readonly score: number;
  readonly low: number | null;
  readonly high: number | null;
  /** The opponents against which it does best and worst. */
  readonly best: number;
  readonly worst: number;
}

export interface Refusal {
  readonly name: string;
  readonly file: string;
  readonly reason: string;
}

export interface Data {
  readonly matrixworld: string;
  readonly title: string;
  readonly world: WorldConfig;
  readonly seed: string;
  readonly match_seed: string;
  readonly episodes: number;
  readonly names: Readonly<Record<Team, readonly string[]>>;
  readonly standings: Readonly<Record<Team, readonly Standing[]>>;
  readonly refusals: readonly Refusal[];
  /** How many students made each choice, by prediction of the course and choice. */
  readonly votes: Readonly<Record<string, Readonly<Record<string, number>>>>;
  /** Of each pair: mean, lowest and highest capture rate of an episode, mean steps. */
  readonly capture_rate: Matrix;
  readonly lowest: Matrix;
  readonly highest: Matrix;
  readonly length: Matrix;
  /** Capture rate and steps of the first episode; -1 steps if the page has no recording of it. */
  readonly first: Matrix;
  readonly steps: Matrix;
}

/** A pair: a pursuer and an evader, by their numbers. */
export interface Pair {
  readonly pursuer: number;
  readonly evader: number;
}

/** Return the data of the page. */
export function readData(): Data {
  return JSON.parse(text("data")) as Data;
}
