// The three real races: a chase, the explorer, and the judgement of one.

import { Board, stillMotion } from "../board/board.ts";
import { recordingOf } from "../board/from_engine.ts";
import { legend } from "../board/legend.ts";
import { Player } from "../board/player.ts";
import { playerBar } from "../board/player_bar.ts";
import { captureSteps } from "../board/recording.ts";
import type { Engine } from "../engine/engine.ts";
import { diagnosisPanel } from "../explorer/diagnosis.ts";
import { MatchPanel } from "../explorer/match.ts";
import { MatrixPanel } from "../explorer/matrix.ts";
import { playedMatch } from "../explorer/play.ts";
import { raceTabs } from "../explorer/races.ts";
import { Store } from "../explorer/store.ts";
import { html } from "../page/dom.ts";
import type { Lesson } from "./data.ts";

/** The race of the chase: the specialists', with the most captures at its end; and steps a second. */
const CHASE = 1;
const SPEED = 8;

/** The last generations of a race, one match. */
export function chase({ runs }: Lesson, engine: Promise<Engine>): HTMLElement {
  const run = runs[CHASE]!;
  const [rows, columns] = run.payoff.shape;
  const player = new Player(0, { speed: SPEED, still: stillMotion() });
  const canvas = html("canvas", { "aria-label": "The chase" });
  const told = html("p", { class: "numbers" });
  const board = new Board(canvas, { numbers: false });
  void engine.then((loaded) => {
    const match = playedMatch(loaded, run, { run: CHASE, pursuer: rows - 1, evader: columns - 1, episode: 0, seed: null });
    const recording = recordingOf(match);
    player.addEventListener("frame", () => board.show(recording, player.time));
    player.addEventListener("step", () => {
      const captured = Array.from(recording.moments[player.step]!.everCaptured).filter(Boolean).length;
      told.textContent = `Step ${player.step}: ${captured} of ${run.world.n_evaders} evaders captured`;
    });
    player.length = match.length;
    player.marks = captureSteps(recording);
    player.jump(0);
  });
  return html("div", { class: "widget chase" }, html("div", { class: "stage" }, canvas), told, playerBar(player), legend());
}

/** The explorer's matrix and match, for all three races. */
export function explorer({ runs, playground }: Lesson, engine: Promise<Engine>): HTMLElement {
  const last = runs[0]!.payoff.shape.map((count) => count - 1) as [number, number];
  const store = new Store({ run: 0, pursuer: last[0], evader: last[1], episode: 0, seed: null });
  const [match, matrix] = [new MatchPanel(runs, store, playground), new MatrixPanel(runs, store)];
  match.actions.remove(); // they open other pages
  matrix.element.addEventListener("play", () => {
    match.playSoon();
    match.reveal();
  });
  void engine.then((loaded) => match.start(loaded));
  const { seed, world } = runs[0]!;
  return html("div", { class: "widget wide" }, raceTabs(runs, store), html("div", { class: "stages" }, matrix.element, match.element),
    html("p", { class: "small muted" }, "Three races of ", html("code", {}, `matrixworld evolve --seed ${seed}`),
      `: ${world.n_pursuers} pursuers and ${world.n_evaders} evaders on ${world.rows} x ${world.cols} cells.`));
}

/** What the program says of an arms race in race A: one row of its judgement. */
export function judgement({ runs }: Lesson): HTMLElement {
  const [run, findings] = [runs[0]!, runs[0]!.findings!];
  const [head, ...rows] = findings.table;
  const row = rows.findIndex(([condition, , , part]) => condition === "arms race" && part === "last half");
  const asked = { headline: run.name, numbers: [], table: [head!, rows[row]!], reasons: [findings.reasons[row]!] };
  return html("div", { class: "widget text" }, diagnosisPanel({ ...run, findings: { ...findings, ...asked } })!.element);
}
