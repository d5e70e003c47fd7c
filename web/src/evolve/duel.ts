// A person plays against the champions of a race: as one of their opponents, from a start that a
// friend can have, too.

import type { Engine } from "../engine/engine.ts";
import type { OfTeams, Team } from "../engine/teams.ts";
import type { GenomePolicy, WorldConfig } from "../engine/types.ts";
import { html } from "../page/dom.ts";
import { playOn } from "../playground/games.ts";
import { liveOf, resultOf } from "../playground/played.ts";
import type { Played, Player, Result } from "../playground/played.ts";
import { PlayView } from "../playground/view.ts";
import type { Dare } from "./story.ts";

/** Steps of a game at most. */
const STEPS = 60;

/** A game: the world and what plays in it, who else could have the seat, and how a friend did. */
export interface DuelOf {
  readonly world: WorldConfig;
  readonly policies: OfTeams<GenomePolicy>;
  readonly players: readonly Player[];
  /** Of the race, and how much its pursuers catch, in percent. */
  readonly seed: number;
  readonly rate: number;
  readonly friend: Dare | null;
}

const QUESTIONS: OfTeams<string> = { evader: "Can you escape them?", pursuer: "Can you catch them?" };

export class Duel {
  readonly dialog = html("dialog", {
    class: "take-over",
    "aria-label": "Play against the champions",
    onclose: () => this.view?.stop(),
    onkeydown: (event: KeyboardEvent) => this.view?.key(event) && event.preventDefault(),
  });
  view: PlayView | null = null;
  readonly #engine: Engine;
  readonly #link: (dare: Dare) => string | null;

  /** `link` returns the address of a dare. */
  constructor(engine: Engine, link: (dare: Dare) => string | null) {
    this.#engine = engine;
    this.#link = link;
  }

  /** Let a person play for a team. */
  play(
    team: Team,
    { world, policies, players, seed, rate, friend }: DuelOf,
    start: Pick<Dare, "seed" | "episode">,
  ): void {
    if (!this.view) {
      this.view = new PlayView(this.#engine);
      this.dialog.append(
        html("button", { type: "button", class: "leave", onclick: () => this.dialog.close() }, "Close"),
        this.view.element,
      );
    }
    if (!this.dialog.open) this.dialog.showModal();
    const config = { ...world, max_steps: Math.min(STEPS, world.max_steps) };
    const seat = team === "evader" ? config.n_pursuers : 0;
    const score = ({ lasted, captured }: Result): number => (team === "evader" ? lasted : captured);
    const most = team === "evader" ? config.max_steps : config.n_evaders;
    const did = (count: number): string =>
      team === "evader" ? `survived ${count} of ${most} steps` : `caught ${count} of ${most} with the team`;
    const dare = (now: Played): Dare => ({
      pursuer: policies.pursuer.genome,
      evader: policies.evader.genome,
      seed: String(now.seed),
      episode: now.episode,
      seat,
      rate,
      score: score(resultOf(liveOf(this.#engine, now), seat)),
    });
    playOn(
      this.#engine,
      this.view,
      { config, seed: BigInt(start.seed), episode: start.episode, policies, seat, from: 0, moves: [] },
      {
        title: QUESTIONS[team],
        players,
        linkName: "Challenge a friend",
        about: `Seed ${seed}: these pursuers catch ${rate} %. ${friend ? `Your friend ${did(friend.score)}` : "You have the seat with the ring"}`,
        told: (result) => {
          if (!friend) return "";
          const own = score(result);
          if (own > friend.score) return `You beat your friend, who ${did(friend.score)}.`;
          return `Your friend ${did(friend.score)}: ${own === friend.score ? "a draw" : "not beaten yet"}.`;
        },
        link: (now) => this.#link(dare(now)),
      },
    );
  }
}
