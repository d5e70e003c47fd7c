// What a game of one's own shows of a pair of generations.

import { html } from "../page/dom.ts";
import { cellOf } from "./data.ts";
import type { Run } from "./data.ts";
import { rate } from "./format.ts";
import { generationName } from "./game.ts";
import type { OwnGame } from "./game.ts";
import type { Selection, Store } from "./store.ts";

/** Pixels of a side under which a picture is drawn in squares. */
const FEW = 200;

/** Return what the game shows of a pair, or why it shows nothing, and the scores of the episodes. */
export function shownPair(
  run: Run,
  game: OwnGame,
  { pursuer, evader }: Selection,
  store: Store,
): HTMLElement[] {
  const { text, image } = game.shows[`${pursuer} ${evader}`] ?? {};
  const rates = cellOf(run, pursuer, evader)?.rates ?? [];
  const scores = `Scores of the ${game.teams[0]} in ${rates.length} episodes: ${rates.map((each) => rate(each)).join(", ")}`;
  const told = toldOf(run, game, pursuer, evader);
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
    told ? html("p", { class: "small numbers" }, told) : null,
    rates.length > 1 ? html("p", { class: "small numbers" }, scores) : null,
  ].filter((each) => each !== null);
}

/** Return the score of the second team, if it has its own, and what else the game tells of a pair. */
function toldOf(run: Run, game: OwnGame, g: number, h: number): string {
  const { others, extras = {} } = run.payoff;
  const second = others?.[g]?.[h];
  const parts = second === undefined ? [] : [`score of the ${game.teams[1]} ${rate(second)}`];
  for (const [name, values] of Object.entries(extras)) {
    const value = values[g]?.[h];
    if (value !== undefined) parts.push(`${name} ${rate(value)}`);
  }
  return parts.length ? `Means of the pair: ${parts.join(", ")}` : "";
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
