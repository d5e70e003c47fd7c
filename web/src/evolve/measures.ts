// Measures of a race that has ended, from its payoff matrix: those of `matrixworld.analysis` with the same names.

import type { Team } from "./settings.ts";

/** Capture rates of pursuers (rows) against evaders (columns). */
export type Rates = readonly (readonly number[])[];

export const mean = (values: ArrayLike<number>): number => Array.from(values).reduce((sum, each) => sum + each, 0) / values.length;

/** Return the payoffs of a team's generations (rows) against those of the other team. */
export const fromSide = (rates: Rates, team: Team): Rates =>
  team === "pursuer" ? rates : rates[0]!.map((_, evader) => rates.map((row) => 1 - row[evader]!));

/** The mean payoff of a team's last generation against all opponents: `pursuer_generalization`, `evader_generalization`. */
export const generalization = (rates: Rates, team: Team): number => mean(fromSide(rates, team).at(-1)!);

/**
 * How far a team falls below its own best so far, mean over opponents and the later half of the generations:
 * `analysis.strength.late_forgetting`. With few episodes luck makes it too high.
 */
export function lateForgetting(rates: Rates, team: Team): number {
  const best: number[] = [];
  const drops = fromSide(rates, team).map((row) => mean(row.map((payoff, opponent) => {
    best[opponent] = Math.max(best[opponent] ?? 0, payoff);
    return best[opponent]! - payoff;
  })));
  return mean(drops.slice(Math.floor(drops.length / 2)));
}
