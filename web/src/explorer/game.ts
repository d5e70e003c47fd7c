// What the game of a run calls its teams and their scores: pursuit, or a game of one's own.

import { TEAMS } from "../engine/teams.ts";
import type { OfTeams, Team } from "../engine/teams.ts";

/** A game of one's own, which the page does not play. */
export interface OwnGame {
  readonly teams: readonly [string, string];
  /** Whether its scores have no noise. */
  readonly exact: boolean;
  /** By the generations of both teams, such as "12 7". */
  readonly shows: Readonly<Record<string, { readonly text?: string; readonly image?: string }>>;
  /** Why nothing is shown of other pairs. */
  readonly missing: string;
}

/** What plays a game; pursuit where none is named. */
interface Played {
  readonly game?: OwnGame | null;
  readonly payoff?: { readonly others?: unknown };
}

/** The words of a game. */
interface GameWords {
  readonly teams: OfTeams<string>;
  /** What counts the generations of a team. */
  readonly generation: OfTeams<string>;
  /** What a cell has, and what the means of both teams are. */
  readonly score: string;
  readonly means: OfTeams<string>;
  /** The same beside the curves, where there is little room. */
  readonly curves: OfTeams<string>;
  /** The ends of the scale of colours. */
  readonly ends: readonly [low: string, high: string];
  readonly lead: string;
  /** What a click on a cell is for. */
  readonly click: string;
}

const PURSUIT: GameWords = {
  teams: { pursuer: "pursuers", evader: "evaders" },
  generation: { pursuer: "pursuer generation", evader: "evader generation" },
  score: "capture rate",
  means: { pursuer: "captures", evader: "escapes" },
  curves: { pursuer: "captures", evader: "escapes" },
  ends: ["0 all escape", "1 all caught"],
  lead: "Each cell is a match between two generations: the brighter, the more evaders are captured. Click one to watch it.",
  click: "watch its match",
};

const ofOwn = ([first, second]: OwnGame["teams"]): GameWords => ({
  teams: { pursuer: first, evader: second },
  generation: { pursuer: `generation of ${first}`, evader: `generation of ${second}` },
  score: `score of the ${first}`,
  means: { pursuer: first, evader: second },
  curves: { pursuer: "scores", evader: "scores" },
  ends: [`0 the ${second} win`, `1 the ${first} win`],
  lead: `Each cell is a pair of generations: the brighter, the higher the score of the ${first}. Click one to see more of it.`,
  click: "see more of it",
});

/** Return the ends of the scale where both teams have scores of their own. */
const OF_BOTH: GameWords["ends"] = ["0 worst", "1 best"];

const ofOne = (name: string): GameWords => ({
  ...ofOwn([name, name]),
  generation: { pursuer: `generation of ${name}`, evader: "generation of the opponent" },
  score: "score",
  ends: ["0 loses", "1 wins"],
  lead: `Each cell is a pair of generations of ${name}: the brighter, the higher the score of the row. Click one to see more of it.`,
});

/** Return the teams of which there is more to say: one population plays both sides. */
export const sidesOf = ({ game }: Played): readonly Team[] =>
  game && game.teams[0] === game.teams[1] ? TEAMS.slice(0, 1) : TEAMS;

export const gameWords = (run: Played): GameWords => {
  if (!run.game) return PURSUIT;
  const words = sidesOf(run).length === 1 ? ofOne(run.game.teams[0]) : ofOwn(run.game.teams);
  return run.payoff?.others ? { ...words, ends: OF_BOTH } : words;
};

/** Return the name of a generation: a number alone would read as a count of agents. */
export const generationName = (run: Played, team: Team, number: number): string =>
  `${gameWords(run).teams[team]} of generation ${number}`;
