// Real races: a chase, one that evolves in the page, the explorer, and the judgement of one.

import { legend } from "../board/legend.ts";
import { playerBar } from "../board/player_bar.ts";
import type { Engine } from "../engine/engine.ts";
import { Chase, Chases, whileSeen } from "../evolve/chase.ts";
import { settingsOf, usualChoice } from "../evolve/choice.ts";
import { Lane } from "../evolve/lane.ts";
import type { RaceSettings } from "../evolve/settings.ts";
import { playedMatch } from "../explorer/data.ts";
import { MatchPanel } from "../explorer/match.ts";
import { MatrixPanel } from "../explorer/matrix.ts";
import { diagnosisPanel } from "../explorer/panel.ts";
import { raceTabs } from "../explorer/races.ts";
import { Store } from "../explorer/store.ts";
import { html } from "../page/dom.ts";
import type { Lesson, WidgetPart } from "./data.ts";

/** The race of the chase: the specialists', with the most captures at its end. */
const CHASE = 1;
/** The world of the races that evolve in the lesson, by networks. */
const WORLD = "meadow";

/** The last generations of a race, one match after the other. */
export function chase({ runs }: Lesson, engine: Promise<Engine>): HTMLElement {
  const run = runs[CHASE]!;
  const {
    shape: [rows, columns],
    episodes,
  } = run.payoff;
  const board = new Chase();
  let episode = 0;
  void engine.then((loaded) => {
    const chases = new Chases(
      () =>
        board.show(
          playedMatch(loaded, run, {
            run: CHASE,
            pursuer: rows - 1,
            evader: columns - 1,
            episode: episode++ % episodes,
            seed: null,
          }),
          `Generation ${rows - 1} of both teams`,
        ),
      board,
    );
    chases.renew();
    whileSeen(chases, board.element);
  });
  return html("div", { class: "widget" }, board.element, playerBar(board.player), legend());
}

/** A race that evolves when it is asked for: its boards alone, or its matrix and curve as well. */
export function evolving(
  { evolve }: Lesson,
  engine: Promise<Engine>,
  { grows = false }: WidgetPart,
): HTMLElement {
  const button = html("button", { type: "button", class: "evolve", disabled: true }, "Evolve");
  const progress = html("progress", { max: 1, value: 0, "aria-label": "Progress of the race" });
  const room = html("div", { class: "lanes", "data-count": 1 });
  void engine.then((loaded) => {
    let seed = -1;
    const settings = (): RaceSettings =>
      settingsOf(evolve, { ...usualChoice(evolve, WORLD), policy: "cells", seed: Math.max(0, seed) });
    const lane = new Lane(evolve, loaded, "lesson", settings());
    const tell = (): void => {
      button.textContent =
        lane.state === "waiting" ? "Evolve" : lane.state === "evolving" ? "Stop" : "Again, with other luck";
      progress.value = lane.done;
    };
    button.addEventListener("click", () => {
      if (lane.state === "evolving") return lane.stop();
      seed++;
      lane.start(settings());
    });
    lane.addEventListener("state", tell);
    if (grows) lane.element.querySelector("details")!.open = true;
    room.append(lane.element);
    whileSeen(lane.chases, lane.boards);
    button.disabled = false;
  });
  return html(
    "div",
    { class: `widget evolving ${grows ? "grows" : "boards"}` },
    html("div", { class: "buttons" }, button, progress),
    room,
  );
}

/** The explorer's matrix and match, for all three races. */
export function explorer({ runs, playground }: Lesson, engine: Promise<Engine>): HTMLElement {
  const last = runs[0]!.payoff.shape.map((count) => count - 1) as [number, number];
  const store = new Store({ run: 0, pursuer: last[0], evader: last[1], episode: 0, seed: null });
  const match = new MatchPanel(runs, store, playground);
  const matrix = new MatrixPanel(runs, store);
  match.actions.remove(); // they open other pages
  matrix.element.addEventListener("play", () => {
    match.playSoon();
    match.reveal();
  });
  void engine.then((loaded) => match.start(loaded));
  const { seed } = runs[0]!;
  const world = runs[0]!.world!;
  return html(
    "div",
    { class: "widget wide" },
    raceTabs(runs, store),
    html("div", { class: "stages" }, matrix.element, match.element),
    html(
      "p",
      { class: "small muted" },
      "Three races of ",
      html("code", {}, `matrixworld evolve --seed ${seed}`),
      `: ${world.n_pursuers} pursuers and ${world.n_evaders} evaders on ${world.rows} x ${world.cols} cells.`,
    ),
  );
}

/** What the program says of an arms race in race A: one row of its judgement. */
export function judgement({ runs }: Lesson): HTMLElement {
  const run = runs[0]!;
  const findings = runs[0]!.findings!;
  const [head, ...rows] = findings.table;
  const row = rows.findIndex(([condition]) => condition === "arms race");
  const asked = { sentence: run.name, table: [head!, rows[row]!], reasons: [findings.reasons[row]!] };
  return html(
    "div",
    { class: "widget text" },
    diagnosisPanel({ ...run, findings: { ...findings, ...asked } })!.element,
  );
}
