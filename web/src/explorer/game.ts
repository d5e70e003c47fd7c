// What the game of a run calls its teams and their scores, and what a game of one's own shows of a pair.

import { html } from "../page/dom.ts";
import { cellOf } from "./data.ts";
import type { Run, Team } from "./data.ts";
import { rate } from "./format.ts";
import type { Selection, Store } from "./store.ts";

type OfTeams = Readonly<Record<Team, string>>;

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

/** The words of a game. */
interface GameWords {
  readonly teams: OfTeams;
  /** What counts the generations of a team. */
  readonly generation: OfTeams;
  /** What a cell has, and what the means of both teams are. */
  readonly score: string;
  readonly means: OfTeams;
  /** The same beside the curves, where there is little room. */
  readonly curves: OfTeams;
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

export const gameWords = ({ game }: Pick<Run, "game">): GameWords => (game ? ofOwn(game.teams) : PURSUIT);

/** Return the name of a generation: a number alone would read as a count of agents. */
export const generationName = (run: Pick<Run, "game">, team: Team, number: number): string =>
  `${gameWords(run).teams[team]} of generation ${number}`;

/** Pixels of a side under which a picture is drawn in squares. */
const FEW = 200;

/** Return what a game of one's own shows of a pair, or why it shows nothing, and the scores of the episodes. */
export function shownPair(
  run: Run,
  game: OwnGame,
  { pursuer, evader }: Selection,
  store: Store,
): HTMLElement[] {
  const { text, image } = game.shows[`${pursuer} ${evader}`] ?? {};
  const rates = cellOf(run, pursuer, evader)?.rates ?? [];
  const scores = `Scores of the ${game.teams[0]} in ${rates.length} episodes: ${rates.map((each) => rate(each)).join(", ")}`;
  return [
    text === undefined
      ? null
      : html("pre", { tabindex: 0, "aria-label": "What the game shows of this pair" }, text),
    image === undefined
      ? null
      : html("img", {
          src: image,
          alt: "What the game shows of this pair",
          onload: ({ target }: { target: HTMLImageElement }) =>
            target.classList.toggle("pixels", target.naturalWidth < FEW),
        }),
    ...((text ?? image) === undefined
      ? [html("p", { class: "muted" }, game.missing), nearest(run, game, pursuer, evader, store)]
      : []),
    rates.length > 1 ? html("p", { class: "small numbers" }, scores) : null,
  ].filter((each) => each !== null);
}

/** Return a button that selects the nearest pair that is shown. */
function nearest(run: Run, game: OwnGame, g: number, h: number, store: Store): HTMLElement | null {
  const pairs = Object.keys(game.shows).map((key) => key.split(" ").map(Number) as [number, number]);
  const away = ([a, b]: readonly [number, number]): number => (a - g) ** 2 + (b - h) ** 2;
  const [pursuer, evader] = pairs.sort((a, b) => away(a) - away(b))[0] ?? [];
  if (pursuer === undefined || evader === undefined) return null;
  const name = `${generationName(run, "pursuer", pursuer)} against ${generationName(run, "evader", evader)}`;
  return html(
    "p",
    {},
    html("button", { type: "button", onclick: () => store.select({ pursuer, evader }) }, `Nearest: ${name}`),
  );
}
