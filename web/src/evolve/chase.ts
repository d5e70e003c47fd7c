// A board on which a match is played, and two of them that begin together: before and after learning.

import { Board, stillMotion } from "../board/board.ts";
import { recordingOf } from "../board/from_engine.ts";
import { Player } from "../board/player.ts";
import { captureSteps } from "../board/recording.ts";
import type { Recording } from "../board/recording.ts";
import type { Match } from "../engine/engine.ts";
import type { Cell } from "../engine/types.ts";
import { html } from "../page/dom.ts";

/** Steps a second. */
const SPEED = 8;
/**
 * Milliseconds between two matches, and those that a match lasts before a newer generation takes
 * its place.
 */
const PAUSE = 900;
const LEAST = 1800;

/**
 * A match on a board. It dispatches `agent` when a person points at one, and `step` and `over`
 * while it goes on.
 */
export class Chase extends EventTarget {
  readonly element: HTMLElement;
  readonly player = new Player(0, { speed: SPEED, still: stillMotion() });
  match: Match | null = null;
  /** The agent that a person has pointed at. */
  agent: number | null = null;
  readonly #title = html("figcaption");
  readonly #canvas = html("canvas", {
    onclick: ({ clientX, clientY }: MouseEvent) => this.#choose(clientX, clientY),
  });
  readonly #board: Board;
  readonly #told = html("p", { class: "small muted numbers" });
  /** Why a wall was not drawn: below the board, which stays where it is. */
  readonly #refused = html("p", { class: "small", role: "status" });
  #recording: Recording | null = null;
  #draws = false;

  constructor() {
    super();
    this.#board = new Board(this.#canvas, { numbers: false });
    this.element = html("figure", { class: "chase" }, this.#title, this.#canvas, this.#told, this.#refused);
    this.player.addEventListener("frame", () => this.#draw());
    this.player.addEventListener("step", () => this.#tell());
    this.player.addEventListener("state", () => this.over && this.dispatchEvent(new Event("over")));
  }

  get over(): boolean {
    return this.player.length > 0 && !this.player.playing && this.player.step === this.player.length;
  }

  get title(): string {
    return this.#title.textContent;
  }

  get recording(): Recording | null {
    return this.#recording;
  }

  /** Show a match from its start; the title says who plays. */
  show(match: Match, title: string): void {
    this.match = match;
    this.#recording = recordingOf(match);
    this.#title.textContent = title;
    this.#canvas.ariaLabel = `A match. ${title}`;
    this.player.jump(0);
    this.player.length = match.length;
    this.player.marks = captureSteps(this.#recording);
    this.#tell();
  }

  /** Mark an agent, and tell who asks of it. */
  choose(agent: number | null): void {
    this.agent = agent;
    this.#board.look = { selected: agent, viewers: agent === null ? [] : [agent] };
    this.dispatchEvent(new Event("agent"));
  }

  #choose(x: number, y: number): void {
    if (!this.#draws) this.choose(this.#board.agentAt(x, y));
  }

  #draw(): void {
    if (this.#recording) this.#board.show(this.#recording, this.player.time);
  }

  #tell(): void {
    const evaders = this.#recording?.moments[this.player.step]?.everCaptured;
    if (evaders) {
      this.#told.textContent = `${Array.from(evaders).filter(Boolean).length} of ${evaders.length} caught in ${this.player.step} steps`;
    }
    this.dispatchEvent(new Event("step"));
  }

  // ---- Walls ------------------------------------------------------------------------------------

  /**
   * Let a finger, a mouse or the keyboard draw walls; `set` gets each cell and whether it becomes a
   * wall, and returns why it does not. Return what begins and ends it.
   */
  drawWalls(set: (cell: Cell, wall: boolean) => string): (on: boolean) => void {
    let active = false;
    let wall = true;
    let cursor: Cell = [0, 0];
    const isWall = ([row, col]: Cell): boolean =>
      Boolean(this.#recording?.obstacles[row * this.#recording.cols + col]);
    const put = (cell: Cell, wall: boolean): void => {
      this.#refused.textContent = set(cell, wall);
    };
    const draw = (event: PointerEvent): void => {
      const cell = this.#board.cellAt(event.clientX, event.clientY);
      if (cell && isWall(cell) !== wall) put(cell, wall);
    };
    this.#canvas.addEventListener("pointerdown", (event) => {
      const cell = active && this.#board.cellAt(event.clientX, event.clientY);
      if (!cell) return;
      this.#canvas.setPointerCapture(event.pointerId);
      wall = !isWall(cell);
      draw(event);
    });
    this.#canvas.addEventListener("pointermove", (event) => active && event.buttons && draw(event));
    this.#canvas.addEventListener("keydown", (event) => {
      const move = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] }[event.key];
      if (!active || !this.#recording || !(move || event.key === " ")) return;
      event.preventDefault();
      const within = (value: number, size: number): number => Math.min(size - 1, Math.max(0, value));
      const { rows, cols } = this.#recording;
      if (move) cursor = [within(cursor[0] + move[0]!, rows), within(cursor[1] + move[1]!, cols)];
      else put(cursor, !isWall(cursor));
      this.#board.look = { cursor };
    });
    return (on) => {
      active = this.#draws = on;
      this.#canvas.classList.toggle("drawn-on", on);
      this.#canvas.tabIndex = on ? 0 : -1;
      this.#canvas.setAttribute("role", on ? "application" : "img");
      this.#board.look = { cursor: null };
    };
  }

  /** Show walls before a match is played among them. */
  showWalls(walls: Uint8Array): void {
    if (!this.#recording) return;
    this.#recording = { ...this.#recording, obstacles: walls };
    this.#draw();
  }
}

/** Boards whose matches begin together, one after the other without end. */
export class Chases {
  readonly boards: readonly Chase[];
  readonly #next: () => void;
  #began = -Infinity;
  #due = 0;
  #runs = !stillMotion();

  /** `next` shows the matches that come next. */
  constructor(next: () => void, ...boards: Chase[]) {
    this.#next = next;
    this.boards = boards;
    for (const each of boards) {
      each.addEventListener(
        "over",
        () => this.#runs && boards.every(({ over }) => over) && this.#soon(PAUSE),
      );
    }
  }

  /** Whether matches are played; otherwise the last ones rest. */
  get runs(): boolean {
    return this.#runs;
  }

  set runs(runs: boolean) {
    this.#runs = runs;
    clearTimeout(this.#due);
    this.#due = 0;
    for (const { player } of this.boards) {
      if (runs) player.play();
      else player.pause();
    }
  }

  /** Begin the next matches: at once, or when the present ones have been seen for a moment. */
  renew(at_once = false): void {
    if (at_once || performance.now() - this.#began > LEAST) this.#begin();
    else if (!this.#due) this.#soon(LEAST);
  }

  #soon(wait: number): void {
    clearTimeout(this.#due);
    this.#due = setTimeout(() => this.#begin(), wait);
  }

  #begin(): void {
    clearTimeout(this.#due);
    this.#due = 0;
    this.#began = performance.now();
    this.#next();
    if (this.#runs) for (const { player } of this.boards) player.play();
  }
}

/** Let boards rest while nobody sees them. */
export function whileSeen(chases: Chases, place: Element): void {
  let ran = chases.runs;
  new IntersectionObserver(([entry]) => {
    if (!entry!.isIntersecting) {
      ran = chases.runs;
      chases.runs = false;
    } else if (ran && !chases.runs) {
      chases.runs = true;
    }
  }).observe(place);
}
