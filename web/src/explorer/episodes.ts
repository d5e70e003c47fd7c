// The episodes of a cell: what the evaluation measured, and whether the page's engine played the same.

import type { Match } from "../engine/engine.ts";
import { html } from "../page/dom.ts";
import { cellOf } from "./data.ts";
import type { Run } from "./data.ts";
import { rate } from "./format.ts";
import type { Store } from "./store.ts";

/** The most episodes with a button of their own. */
const MOST = 40;

export class EpisodeStrip {
  readonly element: HTMLElement;
  readonly #store: Store;
  readonly #buttons = html("div", {
    class: "episodes",
    role: "group",
    "aria-label": "Episodes of this cell",
  });
  readonly #check = html("p", { class: "check small numbers", "aria-live": "polite" });

  constructor(store: Store) {
    this.#store = store;
    this.element = html("div", { class: "strip-of-episodes" }, this.#buttons, this.#check);
  }

  /** Show the episodes of the selected cell, and compare the match that was played with the evaluation. */
  show(run: Run, match: Match): void {
    const { pursuer, evader, episode, seed } = this.#store.selected;
    const cell = cellOf(run, pursuer, evader);
    this.#buttons.replaceChildren(
      ...(cell?.rates ?? []).slice(0, MOST).map((value, place) => this.#button(value, place)),
    );
    const measured = seed === null ? cell?.rates[episode] : undefined;
    const here = match.statistics.capture_rate;
    const equal =
      measured !== undefined && Math.abs(here - measured) < 1e-6 && match.length === cell?.lengths[episode];
    const other = cell
      ? "Not an episode of the evaluation"
      : "The evaluation played no episodes of this pair.";
    this.#check.dataset["equal"] = String(equal);
    this.#check.textContent = equal
      ? "As in the evaluation"
      : measured === undefined
        ? other
        : `Episode ${episode + 1} differs from the evaluation.`;
    this.#check.title = `Played here: capture rate ${rate(here, 3)} in ${match.length} steps.${cell ? ` The cell says ${rate(cell.rate, 3)}.` : ""}`;
  }

  #button(value: number, episode: number): HTMLButtonElement {
    const { selected } = this.#store;
    const bar = html("span", { class: "bar" });
    bar.style.height = `${Math.round(100 * value)}%`;
    return html(
      "button",
      {
        type: "button",
        class: "episode",
        title: `Episode ${episode + 1}: capture rate ${rate(value)}`,
        "aria-label": `Episode ${episode + 1}, capture rate ${rate(value)}`,
        "aria-pressed": String(episode === selected.episode && selected.seed === null),
        onclick: () => this.#store.select({ episode, seed: null }),
      },
      bar,
      html("span", { class: "count" }, episode + 1),
    );
  }
}
