// The settings of a race, as `matrixworld.coevolution.RaceSettings.to_json` writes them. A page's race
// follows those that are named here; the others have the values that Python's page gives them.

import type { WorldConfig } from "../engine/types.ts";
import type { LearnerSettings } from "./learners.ts";

export type Team = "pursuer" | "evader";
export const TEAMS = ["pursuer", "evader"] as const;
export const otherOf = (team: Team): Team => (team === "pursuer" ? "evader" : "pursuer");

/** Which generations of the other team a team meets. */
export type Opponents = "latest" | "round-robin" | "uniform";

interface AnySchedule {
  readonly generations: number;
  readonly pursuers_meet: Opponents;
  readonly evaders_meet: Opponents;
}

/** The teams learn in turns. */
export interface Alternating extends AnySchedule {
  readonly kind: "alternating";
  readonly pursuer_epochs: number;
  readonly evader_epochs: number;
}

/** Both teams learn at once, from living opponents and halls of fame. */
export interface Simultaneous extends AnySchedule {
  readonly kind: "hall-of-fame";
  readonly joint_epochs: number;
  readonly contemporaries: number;
  readonly hall_sample: number;
}

export interface RaceSettings {
  readonly world: WorldConfig;
  readonly policy: {
    readonly hidden: readonly number[];
    readonly initial_weight: number;
    readonly initial_head: number;
    readonly mask: "none" | "right-of-way";
  };
  readonly learner: LearnerSettings;
  readonly schedule: Alternating | Simultaneous;
  readonly train_steps: number;
  readonly evaluation_episodes: number;
  readonly seed: number;
}

/** Penalty of evaders that share a cell, where teammates may. */
const OVERLAP_PENALTY = 0.2;

export const overlapPenalty = ({ world }: RaceSettings): number => (world.rules.teammate === "REACH" ? OVERLAP_PENALTY : 0);
