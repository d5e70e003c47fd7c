// Means, and a payoff matrix as each team sees it.

import type { Team } from "../engine/teams.ts";

/** Capture rates of pursuers (rows) against evaders (columns). */
export type Rates = readonly (readonly number[])[];

export const mean = (values: ArrayLike<number>): number =>
  Array.from(values).reduce((sum, each) => sum + each, 0) / values.length;

/** Return the payoffs of a team's generations (rows) against those of the other team. */
export const fromSide = (rates: Rates, team: Team): Rates =>
  team === "pursuer" ? rates : rates[0]!.map((_, evader) => rates.map((row) => 1 - row[evader]!));
