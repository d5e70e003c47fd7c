// A person takes over an agent of the match that is shown, from its step on.

import type { Engine } from "../engine/engine.ts";
import { TEAMS } from "../engine/teams.ts";
import { html } from "../page/dom.ts";
import { agentName } from "../page/names.ts";
import { playOn } from "../playground/games.ts";
import { linkTo, movesOf, teamOf } from "../playground/played.ts";
import type { Moves } from "../playground/played.ts";
import { PlayView } from "../playground/view.ts";
import { placeOf } from "./address.ts";
import { policyOf, whyNot } from "./data.ts";
import type { Run } from "./data.ts";
import type { MatchPanel } from "./match.ts";
import type { Selection, Store } from "./store.ts";

export class TakeOver {
  readonly dialog = html("dialog", {
    class: "take-over",
    "aria-label": "Play an agent",
    onclose: () => this.view?.stop(),
    onkeydown: (event: KeyboardEvent) => this.view?.key(event) && event.preventDefault(),
  });
  /** The match that a person plays. */
  view: PlayView | null = null;
  readonly #runs: readonly Run[];
  readonly #store: Store;
  readonly #match: MatchPanel;
  #engine: Engine | null = null;

  constructor(runs: readonly Run[], store: Store, match: MatchPanel) {
    this.#runs = runs;
    this.#store = store;
    this.#match = match;
    match.element.addEventListener("takeover", () => this.open());
  }

  /** Begin, with a match that the address holds. */
  start(engine: Engine, address = ""): void {
    this.#engine = engine;
    const place = placeOf(address, this.#runs, this.#store.selected);
    const { world } = this.#runs[place.run]!;
    const moves = world && movesOf(new URLSearchParams(address.replace(/^#/, "")), world);
    if (moves) this.play(place, moves);
  }

  /** Take over the chosen agent, or the first evader that is left; at its end a match begins anew. */
  open(): void {
    const shown = this.#match.shown;
    if (!shown) return;
    const { match, step } = shown;
    this.#match.player.pause();
    const chosen = this.#match.inspector.agent;
    const here = step < match.length ? step : 0;
    const alive = (agent: number, moment: number): boolean =>
      Boolean(match.alive[moment * match.n_agents + agent]);
    const order = Array.from(
      { length: match.n_agents },
      (_, agent) => (agent + match.config.n_pursuers) % match.n_agents,
    );
    const seat = chosen ?? order.find((agent) => alive(agent, here))!;
    const from = alive(seat, here) ? here : 0;
    const moves = Array.from({ length: from }, (_, at) => match.actions[at * match.n_agents + seat]!);
    this.play(this.#store.selected, { seat, from, moves });
  }

  /** Let a person play on in a match, from moves in it. */
  play(place: Selection, moves: Moves): void {
    const engine = this.#engine;
    const run = this.#runs[place.run]!;
    const { world } = run;
    if (!engine || !world || TEAMS.some((each) => whyNot(run, each, place[each]))) return;
    const { run: number, pursuer, evader, episode, seed } = place;
    const team = teamOf(world, moves.seat);
    const players = run.teams[team].kept.map((generation) => ({
      name: run.teams[team].script ?? `generation ${generation}`,
      text: "",
      policy: () => policyOf(run, team, generation),
    }));
    if (!this.view) {
      this.view = new PlayView(engine);
      this.dialog.append(
        html("button", { type: "button", class: "leave", onclick: () => this.dialog.close() }, "Close"),
        this.view.element,
      );
    }
    if (!this.dialog.open) this.dialog.showModal();
    const title = `You are ${agentName(moves.seat, world.n_pursuers)}: ${this.#match.names(place).join(" against ")}`;
    const policies = { pursuer: policyOf(run, "pursuer", pursuer), evader: policyOf(run, "evader", evader) };
    const played = {
      config: world,
      seed: BigInt(seed ?? run.seeds[pursuer]![evader]!),
      episode,
      policies,
      ...moves,
    };
    const address = {
      run: number,
      pursuers: pursuer,
      evaders: evader,
      episode,
      ...(seed === null ? {} : { seed }),
    };
    playOn(engine, this.view, played, { title, players, link: (now) => linkTo(address, now) });
  }
}
