// What became of a race, in a sentence, from its payoff matrix. It claims less than `matrixworld
// judge`, from the same matches: a team is called better or weaker only if its strength against all
// opponents changed as much, too.

import { TEAMS, otherOf } from "../engine/teams.ts";
import type { OfTeams, Team } from "../engine/teams.ts";
import { fromSide, mean } from "./measures.ts";
import type { Rates } from "./measures.ts";
import type { Cell } from "./race.ts";

export type Verdict = "better" | "better by a jump" | "weaker" | "cannot tell";

export interface Outcome {
  /** Capture rate of the best pursuers and evaders against each other; the generation of each. */
  readonly rate: number;
  readonly best: OfTeams<number>;
  /**
   * Whether a team's last generations do better than its generation 0 against the last ones of the
   * other team, and how well both do.
   */
  readonly teams: OfTeams<{ readonly verdict: Verdict; readonly before: number; readonly after: number }>;
  readonly sentence: string;
}

/** Share of the generations that are its last ones. */
const LAST = 1 / 4;
/**
 * Standard deviations of an interval that holds 95 %, and the least change of strength:
 * `LEAST_GAIN` of `judge`.
 */
const REACH = 1.96;
const LEAST = 0.05;
/** Parts of a course, none of which may fall back if it is sustained. */
const PARTS = 5;

interface Estimate {
  readonly value: number;
  readonly reach: number;
}

/**
 * Return the outcome of a race of so many generations; null without a second one or with cells that
 * are missing.
 */
export function outcomeOf(
  cells: ReadonlyMap<string, Pick<Cell, "capture_rates">>,
  generations: number,
): Outcome | null {
  const all = Array.from({ length: generations }, (_, g) =>
    Array.from({ length: generations }, (_none, h) => cells.get(`${g} ${h}`)?.capture_rates),
  );
  if (generations < 2 || all.some((row) => row.includes(undefined))) return null;
  const rates = all.map((row) => row.map((each) => mean(each!)));
  const noise = all.map((row) => row.map((each) => varianceOfMean(each!)));
  const last = Math.max(1, Math.round(generations * LAST));
  const teamOf = (team: Team): Outcome["teams"][Team] => {
    const own = fromSide(rates, team);
    const errors = team === "pursuer" ? noise : transposed(noise);
    const before = [own[0]!.slice(-last)];
    const after = own.slice(-last).map((row) => row.slice(-last));
    const errorOf = (rows: Rates): number =>
      mean(rows.map((row) => mean(row.slice(-last)) / last)) / rows.length;
    const difference = {
      value: mean(after.map(mean)) - mean(before.map(mean)),
      reach: REACH * Math.sqrt(errorOf(errors.slice(-last)) + errorOf([errors[0]!])),
    };
    const change = changeOf(own, errors);
    const told = verdictOf(difference, change);
    return {
      verdict: told === "better" && !isSustained(own.map(mean), change.value) ? "better by a jump" : told,
      before: mean(before[0]!),
      after: mean(after.map(mean)),
    };
  };
  const teams = { pursuer: teamOf("pursuer"), evader: teamOf("evader") };
  const bestOf = (team: Team): number => {
    const means = fromSide(rates, team).map(mean);
    return means.lastIndexOf(Math.max(...means));
  };
  const best = { pursuer: bestOf("pursuer"), evader: bestOf("evader") };
  const rate = rates[best.pursuer]![best.evader]!;
  return { rate, best, teams, sentence: sentenceOf(rate, teams) };
}

const transposed = (rows: Rates): Rates => rows[0]!.map((_, at) => rows.map((row) => row[at]!));
const varianceOfMean = (values: readonly number[]): number =>
  values.reduce((sum, each) => sum + (each - mean(values)) ** 2, 0) /
  Math.max(1, values.length - 1) /
  values.length;

/** The linear change of a team's mean payoff against all opponents: `analysis.strength.strength_change`. */
function changeOf(own: Rates, errors: Rates): Estimate {
  const steps = own.length - 1;
  const places = own.map((_, at) => at - steps / 2);
  const squares = places.reduce((sum, place) => sum + place * place, 0);
  const weights = places.map((place) => (steps * place) / squares);
  const variances = errors.map((row) => mean(row) / row.length);
  return {
    value: own.reduce((sum, row, at) => sum + weights[at]! * mean(row), 0),
    reach: REACH * Math.sqrt(variances.reduce((sum, each, at) => sum + weights[at]! ** 2 * each, 0)),
  };
}

/**
 * Return whether a course keeps its direction, without a jump that is half of its change:
 * `analysis.strength.is_sustained`.
 */
function isSustained(course: readonly number[], change: number): boolean {
  const forward = course.map((each) => each * Math.sign(change));
  const size = Math.floor(course.length / PARTS);
  const more = course.length % PARTS;
  const parts = Array.from({ length: PARTS }, (_, part) =>
    mean(forward.slice(part * size + Math.min(part, more), (part + 1) * size + Math.min(part + 1, more))),
  );
  const tenth = Math.max(2, Math.floor(course.length / 10));
  const jump = Math.max(...forward.slice(tenth).map((each, at) => each - forward[at]!));
  const setback = Math.max(...parts.slice(1).map((each, part) => parts[part]! - each));
  return jump < Math.abs(change) / 2 && setback < Math.abs(change) / 4;
}

function verdictOf(...estimates: readonly Estimate[]): Verdict {
  if (estimates.every(({ value, reach }) => value - reach > LEAST)) return "better";
  return estimates.every(({ value, reach }) => value + reach < -LEAST) ? "weaker" : "cannot tell";
}

export const percent = (rate: number): string => `${Math.round(100 * rate)} %`;

const WORDS: Readonly<Record<Verdict, string>> = {
  better: "better than in generation 0",
  "better by a jump": "better than in generation 0, most of it in one jump",
  weaker: "weaker than in generation 0",
  "cannot tell": "",
};

function sentenceOf(rate: number, teams: Outcome["teams"]): string {
  const now = `The best pursuers now catch ${percent(rate)} of the best evaders.`;
  const words = TEAMS.map((team) => WORDS[teams[team].verdict]);
  if (words[0] === words[1]) {
    return words[0]
      ? `${now} Both teams are ${words[0]}.`
      : `${now} Whether a team has become better since generation 0, this race cannot tell.`;
  }
  const parts = TEAMS.map((team, place) =>
    words[place] ? `the ${team}s are ${words[place]}` : `of the ${team}s this race cannot tell`,
  );
  return `${now} ${parts[0]![0]!.toUpperCase()}${parts[0]!.slice(1)}; ${parts[1]}.`;
}

/** Return what a team's verdict rests on, in a sentence. */
export function evidenceOf(team: Team, { before, after }: Outcome["teams"][Team]): string {
  const [one, other] = team === "pursuer" ? [before, after] : [1 - before, 1 - after];
  return team === "pursuer"
    ? `Of the last ${otherOf(team)}s, pursuers of generation 0 catch ${percent(one)}, the last pursuers ${percent(other)}.`
    : `The last pursuers catch ${percent(one)} of the evaders of generation 0, and ${percent(other)} of the last evaders.`;
}
