// The episodes of a cell: what the evaluation measured, and what the page's engine plays.

import type { Player } from "../board/player.ts";
import type { Engine, Match } from "../engine/engine.ts";
import { html } from "../page/dom.ts";
import { cellOf } from "./data.ts";
import type { Run } from "./data.ts";
import { rate } from "./format.ts";
import { playedMatch } from "./play.ts";
import type { Selection, Store } from "./store.ts";

/** The most episodes with a button of their own. */
const MOST = 40;

/** Results that the page has played, by run, cell and episode. */
const played = new Map<string, { rate: number; length: number }>();
const keyOf = ({ run, pursuer, evader }: Selection, episode: number): string => `${run} ${pursuer} ${evader} ${episode}`;

export class EpisodeStrip {
  readonly element: HTMLElement;
  readonly #store: Store;
  readonly #player: Player;
  readonly #buttons = html("div", { class: "episodes", role: "group", "aria-label": "Episodes of this cell" });
  readonly #check = html("p", { class: "check small numbers", "aria-live": "polite" });
  #waiting = 0;

  constructor(store: Store, player: Player) {
    [this.#store, this.#player] = [store, player];
    this.element = html("div", { class: "strip-of-episodes" }, this.#buttons, this.#check);
  }

  /** Show the episodes of the selected cell; the others are played while nothing moves. */
  show(engine: Engine, run: Run, match: Match): void {
    const { selected } = this.#store;
    if (selected.seed === null) played.set(keyOf(selected, selected.episode), resultOf(match));
    this.#draw(run);
    cancelIdle(this.#waiting);
    this.#playNext(engine, run);
  }

  #playNext(engine: Engine, run: Run): void {
    const { selected } = this.#store;
    const cell = cellOf(run, selected.pursuer, selected.evader);
    const next = cell?.rates.findIndex((_, episode) => !played.has(keyOf(selected, episode))) ?? -1;
    if (next < 0 || next >= MOST) return;
    this.#waiting = whenIdle(() => {
      // Another match is selected by now: `show` begins with its cell, if the page holds its genomes.
      if (this.#store.selected !== selected) return;
      // Pictures of a match that moves come first.
      if (!this.#player.playing) {
        played.set(keyOf(selected, next), resultOf(playedMatch(engine, run, { ...selected, episode: next, seed: null })));
        this.#draw(run);
      }
      this.#playNext(engine, run);
    });
  }

  #draw(run: Run): void {
    const { selected } = this.#store;
    const cell = cellOf(run, selected.pursuer, selected.evader);
    if (!cell) {
      this.#buttons.replaceChildren();
      this.#check.textContent = "The evaluation played no episodes of this pair.";
      return;
    }
    const shown = Math.min(MOST, cell.rates.length);
    this.#buttons.replaceChildren(...cell.rates.slice(0, shown).map((value, episode) => this.#button(value, episode)));
    const here = cell.rates.slice(0, shown).map((_, episode) => played.get(keyOf(selected, episode)));
    const done = here.filter((each) => each !== undefined);
    const wrong = here.flatMap((each, episode) =>
      each && (Math.abs(each.rate - cell.rates[episode]!) > 1e-6 || each.length !== cell.lengths[episode]) ? [episode + 1] : []);
    const mean = done.reduce((sum, each) => sum + each.rate, 0) / done.length;
    this.#check.dataset["equal"] = String(!wrong.length && done.length === cell.rates.length);
    this.#check.textContent = wrong.length ? `Episode ${wrong.join(", ")} differs from the evaluation.` : "As in the evaluation";
    this.#check.title = done.length < cell.rates.length
      ? `Played here: ${done.length} of ${cell.rates.length} episodes.`
      : `Played here: all ${done.length} episodes, mean capture rate ${rate(mean, 3)}. The cell says ${rate(cell.rate, 3)}.`;
  }

  #button(value: number, episode: number): HTMLButtonElement {
    const { selected } = this.#store;
    const bar = html("span", { class: "bar" });
    bar.style.height = `${Math.round(100 * value)}%`;
    return html(
      "button",
      {
        type: "button", class: "episode", title: `Episode ${episode + 1}: capture rate ${rate(value)}`,
        "aria-label": `Episode ${episode + 1}, capture rate ${rate(value)}`,
        "aria-pressed": String(episode === selected.episode && selected.seed === null),
        "data-played": played.has(keyOf(selected, episode)),
        onclick: () => this.#store.select({ episode, seed: null }),
      },
      bar, html("span", { class: "count" }, episode + 1),
    );
  }
}

const resultOf = (match: Match): { rate: number; length: number } => ({ rate: match.statistics.capture_rate, length: match.length });

// Safari has no idle callbacks.
const whenIdle = (act: () => void): number =>
  "requestIdleCallback" in window ? requestIdleCallback(act, { timeout: 1000 }) : setTimeout(act, 100);
const cancelIdle = (handle: number): void => ("cancelIdleCallback" in window ? cancelIdleCallback(handle) : clearTimeout(handle));
