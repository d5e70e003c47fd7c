// Checkerboards: two pursuer and two evader generations, each better against one opponent. A click
// plays their four matches side by side.

import { Board, stillMotion } from "../board/board.ts";
import { recordingOf } from "../board/from_engine.ts";
import { FITTING, Player, playerKey } from "../board/player.ts";
import { playerBar } from "../board/player_bar.ts";
import type { Engine } from "../engine/engine.ts";
import { dialog } from "../page/dialog.ts";
import { html } from "../page/dom.ts";
import { generationName } from "../page/names.ts";
import { inkOn, viridisText } from "./colormap.ts";
import { playedMatch, whyNot } from "./data.ts";
import type { Checkerboard, Run } from "./data.ts";
import { rate } from "./format.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";
import type { Store } from "./store.ts";

export function checkerboardPanel(run: Run, store: Store, engine: () => Engine | null): Panel | null {
  const { findings } = run;
  if (!findings?.table.length) return null; // they are shown beside the judgement
  const room = html("div");
  const four = dialog("Four matches of a checkerboard", "four", room);
  const open = (board: Checkerboard): void => {
    const started = engine();
    if (started) showFour(four, room, run, board, store, started);
  };
  const boards = findings.checkerboards.map((board) => miniature(run, board, open));
  return {
    element: card("Checkerboards",
      "Two generations of each team: each generation of the pursuers is better against another one of the evaders. Click one: its four matches side by side.",
      boards.length
        ? html("div", { class: "boards" }, ...boards)
        : html("p", {}, `No four cells differ by more than ${findings.margin} in this way.`),
      boards.length ? html("p", { class: "small muted" }, "The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes.") : null,
      four),
  };
}

const cellsOf = ({ pursuers: [p, q], evaders: [a, b] }: Checkerboard): readonly (readonly [number, number])[] =>
  [[p, a], [p, b], [q, a], [q, b]];

function miniature(run: Run, board: Checkerboard, open: (board: Checkerboard) => void): HTMLElement {
  const [p, q] = board.pursuers;
  const [a, b] = board.evaders;
  const cells = cellsOf(board).map(([g, h]) => {
    const value = run.payoff.capture_rate[g]![h]!;
    const cell = html("span", { class: "cell" }, rate(value));
    cell.style.backgroundColor = viridisText(value);
    cell.style.color = inkOn(value);
    return cell;
  });
  return html("button", { type: "button", class: "miniature numbers", onclick: () => open(board) },
    html("span", {}, html("span", { class: "heard" }, `Four matches of generations ${p} and ${q} of the pursuers, ${a} and ${b} of the evaders:`)), html("span", { class: "evader" }, a), html("span", { class: "evader" }, b),
    html("span", { class: "pursuer" }, p), cells[0]!, cells[1]!,
    html("span", { class: "pursuer" }, q), cells[2]!, cells[3]!);
}

/** Play the four matches of a checkerboard, step by step together. */
function showFour(dialog: HTMLDialogElement, room: HTMLElement, run: Run, board: Checkerboard, store: Store, engine: Engine): void {
  const playable = cellsOf(board).filter(([g, h]) => !whyNot(run, "pursuer", g) && !whyNot(run, "evader", h));
  const matches = playable.map(([pursuer, evader]) =>
    playedMatch(engine, run, { run: store.selected.run, pursuer, evader, episode: 0, seed: null }));
  const player = new Player(Math.max(0, ...matches.map((match) => match.length)), { speed: FITTING, still: stillMotion() });
  const views = matches.map((match, i) => {
    const [g, h] = playable[i]!;
    const canvas = html("canvas", { "aria-label": `${generationName("pursuer", g)} against ${generationName("evader", h)}` });
    const tally = html("span", { class: "numbers" });
    const go = (): void => {
      dialog.close();
      store.select({ pursuer: g, evader: h });
    };
    const element = html("figure", {}, canvas,
      html("figcaption", { class: "small" }, tally, html("span", { class: "muted" }, `cell ${rate(run.payoff.capture_rate[g]![h])}`),
        html("button", { type: "button", title: "Show this match alone", onclick: go }, "open")));
    element.style.gridArea = `${board.pursuers.indexOf(g) + 2} / ${board.evaders.indexOf(h) + 2}`;
    return { element, match, recording: recordingOf(match), board: new Board(canvas, { numbers: false }), tally };
  });
  const draw = (): void => views.forEach((view) => view.board.show(view.recording, player.time));
  const tell = (): void => views.forEach(({ recording, match, tally }) => {
    const moment = recording.moments[Math.min(player.step, match.length)]!;
    tally.textContent = `${Array.from(moment.everCaptured).filter(Boolean).length} of ${match.config.n_evaders} captured`;
  });
  player.addEventListener("frame", draw);
  player.addEventListener("step", tell);
  room.replaceChildren(
    html("div", { class: "grid-of-four" },
      html("span"), ...board.evaders.map((h) => html("h3", { class: "evader" }, generationName("evader", h))),
      ...board.pursuers.map((g, row) => {
        const heading = html("h3", { class: "pursuer" }, generationName("pursuer", g));
        heading.style.gridArea = `${row + 2} / 1`;
        return heading;
      }),
      ...views.map((view) => view.element)),
    playerBar(player));
  const key = (event: KeyboardEvent): void => {
    const own = event.target instanceof HTMLSelectElement || (event.target instanceof HTMLButtonElement && event.key === " ");
    if (!own && !event.defaultPrevented && playerKey(player, event)) event.preventDefault();
  };
  dialog.addEventListener("keydown", key);
  dialog.addEventListener("close", () => {
    dialog.removeEventListener("keydown", key);
    player.pause();
    views.forEach((view) => view.board.close());
    room.replaceChildren();
  }, { once: true });
  store.dispatchEvent(new Event("rest"));
  dialog.showModal();
  draw();
  tell();
  if (!stillMotion()) player.play();
}
