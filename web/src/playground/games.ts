// What a person plays: "Can you escape it?", and one match, at whose end others take the same seat.

import type { Live } from "../board/live.ts";
import type { Engine } from "../engine/engine.ts";
import type { WorldConfig } from "../engine/types.ts";
import { html } from "../page/dom.ts";
import type { OpponentsData } from "./data.ts";
import { ladder, fairSeed, resultInSeat, resultOf, teamOf } from "./played.ts";
import type { Played, Player, Result } from "./played.ts";
import type { Game, PlayView } from "./view.ts";

const SIDE = 20;
const STEPS = 60;

/** A round of "Can you escape it?": a world with a single evader, and its pursuers. */
interface Round {
  readonly config: WorldConfig;
  readonly rival: Player;
}

/** Return rounds against pursuers of three strengths, in a small world with as few of them as can capture. */
function roundsOf(world: WorldConfig, pursuers: readonly Player[]): Round[] {
  const most = world.rules.capture === "SURROUND" ? 8 : 4;
  const mapped = typeof world.obstacles !== "number";
  const side = (own: number): number => (mapped ? own : Math.min(own, SIDE));
  const config = {
    ...world,
    rows: side(world.rows),
    cols: side(world.cols),
    max_steps: STEPS,
    n_evaders: 1,
    n_pursuers: Math.min(world.n_pursuers, most),
  };
  return ladder(pursuers).map((rival) => ({ config, rival }));
}

/** Play one evader in three rounds that are harder and harder, for a score. */
export function escapeGame(
  engine: Engine,
  view: PlayView,
  data: Pick<OpponentsData, "world" | "rounds">,
  pursuers: readonly Player[],
): void {
  const rounds: readonly Round[] = data.rounds.length
    ? data.rounds.map(({ world: config, pursuers: name, text }) => ({
        config,
        rival: { name: `${name.replaceAll("-", " ")}s`, text, policy: () => name },
      }))
    : roundsOf(data.world, pursuers);
  const scores: number[] = [];
  const score = (): string =>
    `${scores.reduce((sum, each) => sum + each, 0)} of ${rounds.reduce((sum, { config }) => sum + config.max_steps, 0)}`;
  const round = (): void => {
    const { config, rival } = rounds[scores.length]!;
    view.play({
      title: `Can you escape it? Round ${scores.length + 1} of ${rounds.length}, ${config.n_pursuers} pursuers: ${rival.name}`,
      about: rival.text && `${rival.name}: ${rival.text}`,
      played: {
        config,
        seed: fairSeed(engine, config, config.n_pursuers),
        episode: 0,
        seat: config.n_pursuers,
        from: 0,
        moves: [],
        policies: { pursuer: rival.policy(), evader: "still" },
      },
      ending: (live) => {
        scores.push(resultOf(live, config.n_pursuers).lasted);
        const rows = rounds.map(({ rival: { name } }, place) =>
          html("tr", {}, html("th", { scope: "row" }, name), html("td", {}, scores[place] ?? "")),
        );
        const left = scores.length < rounds.length;
        return [
          html(
            "table",
            { class: "numbers" },
            html("caption", {}, `Steps of ${config.max_steps} in each round`),
            ...rows,
          ),
          html(
            "p",
            { class: "play-score" },
            left ? "Score so far: " : "Your score: ",
            html("strong", {}, score()),
          ),
          left ? html("button", { type: "button", class: "primary", onclick: round }, "Next round") : "",
        ];
      },
      again: () => escapeGame(engine, view, data, pursuers),
      link: () => null,
    });
  };
  round();
}

/** What plays a match on: its title, who is compared at its end and what is said there, and its link. */
interface PlayedOn extends Pick<Game, "title" | "about" | "link" | "linkName"> {
  readonly players: readonly Player[];
  readonly told?: (result: Result) => string;
}

/** Play a match on from its moves. */
export function playOn(engine: Engine, view: PlayView, played: Played, on: PlayedOn): void {
  const { players, told, ...game } = on;
  view.play({
    ...game,
    played,
    ending: (live, now) => [
      told ? html("p", {}, told(resultOf(live, played.seat))) : "",
      comparison(engine, live, now, ladder(players)),
    ],
    again: () => playOn(engine, view, { ...played, moves: played.moves.slice(0, played.from) }, on),
  });
}

/** Return a table of the person and of others in the same seat of the same match. */
function comparison(engine: Engine, live: Live, played: Played, players: readonly Player[]): HTMLElement {
  const evader = teamOf(played.config, played.seat) === "evader";
  const most = evader ? played.config.max_steps : played.config.n_evaders;
  const table = html(
    "table",
    { class: "numbers" },
    html(
      "caption",
      {},
      evader
        ? "Steps in your seat: same start, same others"
        : "Captures of your team: same start, same others",
    ),
  );
  const row = (name: string): ((result: Result) => void) => {
    const bar = html("span", { class: evader ? "bar evader" : "bar pursuer" });
    const value = html("td", {}, "…");
    table.append(
      html(
        "tr",
        {},
        html("th", { scope: "row" }, name),
        html("td", { class: "track", "aria-hidden": "true" }, bar),
        value,
      ),
    );
    return ({ lasted, captured }) => {
      bar.style.width = `${(100 * (evader ? lasted : captured)) / most}%`;
      value.textContent = String(evader ? lasted : captured);
    };
  };
  row("You")(resultOf(live, played.seat));
  // Each is a whole match: the page shows the end before they are played.
  for (const { name, policy } of players) {
    const fill = row(name);
    setTimeout(() => fill(resultInSeat(engine, played, policy())));
  }
  const began = played.from ? `You took over at step ${played.from}. ` : "";
  return html(
    "div",
    {},
    table,
    html("p", { class: "small muted" }, `${began}One match: luck has its part in it.`),
  );
}
