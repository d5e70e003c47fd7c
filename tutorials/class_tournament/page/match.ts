// The selected match: its first episode, played again from the recorded actions.

import { Board, stillMotion } from "../../../web/src/board/board.ts";
import { legend } from "../../../web/src/board/legend.ts";
import { FITTING, Player } from "../../../web/src/board/player.ts";
import { playerBar } from "../../../web/src/board/player_bar.ts";
import { captureSteps } from "../../../web/src/board/recording.ts";
import type { Engine } from "../../../web/src/engine/engine.ts";
import { rate } from "../../../web/src/explorer/format.ts";
import { wordsOf } from "../../../web/src/explorer/words.ts";
import { html } from "../../../web/src/page/dom.ts";
import type { Live } from "../../../web/src/board/live.ts";
import type { Data } from "./data.ts";
import { Recordings } from "./recordings.ts";
import type { Store } from "./store.ts";

export class MatchPanel {
  readonly element: HTMLElement;
  readonly player = new Player(0, { speed: FITTING, still: stillMotion() });
  /** The match that is shown; null where the page has no recording of it. */
  replay: Live | null = null;
  readonly #data: Data;
  readonly #store: Store;
  readonly #recordings: Recordings;
  readonly #board: Board;
  readonly #title = html("h2", { class: "match-title" });
  readonly #tally = html("p", { class: "tally numbers" });
  readonly #words = html("ol", {
    class: "words",
    "aria-live": "off",
    "aria-label": "What happened in this step",
  });
  readonly #note = html("p", { class: "check small", "aria-live": "polite" });
  #engine: Engine | null = null;

  constructor(data: Data, store: Store) {
    this.#data = data;
    this.#store = store;
    this.#recordings = new Recordings(data);
    const canvas = html("canvas", { "aria-label": "The match" });
    this.#board = new Board(canvas, { numbers: false });
    this.element = html(
      "section",
      { class: "card match-card", "aria-label": "Match", id: "match" },
      html("header", { class: "match-head" }, this.#title, this.#tally),
      html("div", { class: "stage" }, canvas),
      playerBar(this.player),
      this.#note,
      legend(),
      this.#words,
    );
    this.player.addEventListener(
      "frame",
      () => this.replay && this.#board.show(this.replay.recording, this.player.time),
    );
    this.player.addEventListener("step", () => this.#tell());
    store.on("pair", () => this.#load());
    store.on("play", () => this.#play());
    this.#entitle();
  }

  start(engine: Engine): void {
    this.#engine = engine;
    this.#load();
  }

  #play(): void {
    if (!this.replay) return;
    this.player.jump(0);
    if (!stillMotion()) this.player.play();
    // On a narrow page the board is below what was clicked.
    this.element.scrollIntoView({ block: "nearest" });
  }

  #load(): void {
    this.player.pause();
    this.#entitle();
    const { pair } = this.#store;
    if (!this.#engine) return;
    this.replay = this.#recordings.has(pair) ? this.#recordings.play(this.#engine, pair) : null;
    this.element.dataset["played"] = this.replay ? `${pair.pursuer} ${pair.evader}` : "";
    this.element.classList.toggle("without-recording", !this.replay);
    this.player.length = this.replay?.length ?? 0;
    this.player.marks = this.replay ? captureSteps(this.replay.recording) : [];
    this.player.jump(0);
    this.#check();
    this.#tell();
  }

  /** Say whether the engine here and the tournament agree. */
  #check(): void {
    const { pursuer, evader } = this.#store.pair;
    if (!this.replay) {
      this.#note.textContent = "The page holds no recording of this match: it would be too large.";
      return;
    }
    const here = this.replay.statistics.capture_rate;
    const there = this.#data.first[pursuer]![evader]!;
    const equal = Math.abs(here - there) < 1e-3;
    this.#note.dataset["equal"] = String(equal);
    this.#note.textContent = equal
      ? `Episode 1 of ${this.#data.episodes}: capture rate ${rate(here)}, as in the tournament.`
      : `Episode 1 of ${this.#data.episodes}: capture rate ${rate(here)}; the tournament had ${rate(there)}.`;
  }

  #entitle(): void {
    const { pursuer, evader } = this.#store.pair;
    this.#title.replaceChildren(
      html("span", { class: "pursuer" }, this.#data.names.pursuer[pursuer]!),
      " against ",
      html("span", { class: "evader" }, this.#data.names.evader[evader]!),
    );
  }

  #tell(): void {
    if (!this.replay) {
      this.#words.replaceChildren();
      this.#tally.replaceChildren();
      return;
    }
    const { recording } = this.replay;
    const step = this.player.step;
    const captured = Array.from(recording.moments[step]!.everCaptured).filter(Boolean).length;
    this.#tally.replaceChildren(
      html("strong", {}, captured),
      ` of ${this.#data.world.n_evaders} captured`,
      html("span", { class: "muted" }, ` · step ${step}`),
    );
    this.#words.replaceChildren(
      ...wordsOf(this.replay, recording, step).map((word) => html("li", { class: word.kind }, word.text)),
    );
  }
}
