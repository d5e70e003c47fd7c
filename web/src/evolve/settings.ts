// The settings of a race, as `matrixworld.coevolution.RaceSettings.to_json` writes them. A page's race
// follows those that are named here; the others have the values that Python's page gives them.

import type { Team } from "../engine/teams.ts";
import type { RatingPolicy, WorldConfig } from "../engine/types.ts";
import type { LearnerSettings } from "./learners.ts";

/** Which generations of the other team a team meets. */
export type Opponents = "latest" | "round-robin" | "uniform";

interface AnySchedule extends Readonly<Record<"pursuers_meet" | "evaders_meet", Opponents>> {
  readonly generations: number;
}

/** The teams learn in turns. */
interface Alternating extends AnySchedule, Readonly<Record<"pursuer_epochs" | "evader_epochs", number>> {
  readonly kind: "alternating";
}

/** Both teams learn at once, from living opponents and halls of fame. */
interface Simultaneous
  extends AnySchedule, Readonly<Record<"joint_epochs" | "contemporaries" | "hall_sample", number>> {
  readonly kind: "hall-of-fame";
}

/** Networks over the cells of a view. */
interface Cells {
  readonly kind: "cells";
  readonly hidden: readonly number[];
  readonly initial_weight: number;
  readonly initial_head: number;
  readonly mask: "none" | "right-of-way";
}

type Inputs = RatingPolicy["inputs"];

/** Policies that rate moves by a weighted sum of named inputs, those of both teams or of each. */
export interface Ratings extends Omit<RatingPolicy, "genome" | "inputs"> {
  readonly inputs: Inputs | readonly [pursuers: Inputs, evaders: Inputs];
  readonly initial_weight: number;
}

export interface RaceSettings {
  readonly world: WorldConfig;
  readonly policy: Cells | Ratings;
  readonly learner: LearnerSettings;
  readonly schedule: Alternating | Simultaneous;
  readonly train_steps: number;
  readonly evaluation_episodes: number;
  readonly seed: number;
}

/** Return the inputs of a team. */
export function inputsOf({ inputs }: Ratings, team: Team): Inputs {
  const isPair = (each: Ratings["inputs"]): each is readonly [Inputs, Inputs] => typeof each[0] !== "string";
  return isPair(inputs) ? inputs[team === "pursuer" ? 0 : 1] : inputs;
}

/** Penalty of evaders that share a cell, where teammates may. */
const OVERLAP_PENALTY = 0.2;

export const overlapPenalty = ({ world }: RaceSettings): number =>
  world.rules.teammate === "REACH" ? OVERLAP_PENALTY : 0;
