// A board on which one match follows the other, without end.

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
/** Milliseconds between two matches, and those that a match lasts before a newer generation takes its place. */
const PAUSE = 700;
const LEAST = 1400;

export class Chase {
  readonly element: HTMLElement;
  readonly player = new Player(0, { speed: SPEED, still: stillMotion() });
  readonly title = html("figcaption");
  /** Of the newest team on the board. */
  generation = 0;
  readonly #canvas = html("canvas");
  readonly #board: Board;
  readonly #told = html("p", { class: "small muted numbers" });
  /** Why a wall was not drawn: below the board, which stays where it is. */
  readonly #refused = html("p", { class: "small", role: "status" });
  readonly #next: () => Match | null;
  #recording: Recording | null = null;
  #began = 0;
  #due = 0;
  #runs = !stillMotion();

  /** `next` plays the match that comes next. */
  constructor(next: () => Match | null) {
    this.#next = next;
    this.#board = new Board(this.#canvas, { numbers: false });
    this.element = html("figure", { class: "chase" }, this.title, this.#canvas, this.#told, this.#refused);
    this.player.addEventListener("frame", () => this.#draw());
    this.player.addEventListener("step", () => this.#tell());
    this.player.addEventListener("state", () => {
      if (this.#runs && !this.player.playing && this.player.length && this.player.step === this.player.length) this.#soon();
    });
  }

  /** What the board shows, in words for readers who do not see it. */
  set label(text: string) {
    this.#canvas.ariaLabel = text;
  }

  /** Whether matches are played; otherwise the last one rests. */
  get runs(): boolean {
    return this.#runs;
  }

  set runs(runs: boolean) {
    this.#runs = runs;
    clearTimeout(this.#due);
    if (runs) this.player.play();
    else this.player.pause();
  }

  /** Begin the next match: at once, or when the present one has been seen for a moment. */
  renew(at_once = false): void {
    if (at_once || !this.#recording || performance.now() - this.#began > LEAST) this.#begin();
    else this.#soon(LEAST);
  }

  #soon(wait = PAUSE): void {
    clearTimeout(this.#due);
    this.#due = setTimeout(() => this.#begin(), wait);
  }

  #begin(): void {
    clearTimeout(this.#due);
    const match = this.#next();
    if (!match) return;
    this.#recording = recordingOf(match);
    this.#began = performance.now();
    this.player.jump(0);
    this.player.length = match.length;
    this.player.marks = captureSteps(this.#recording);
    this.#tell();
    if (this.#runs) this.player.play();
  }

  #draw(): void {
    if (this.#recording) this.#board.show(this.#recording, this.player.time);
  }

  #tell(): void {
    const evaders = this.#recording?.moments[this.player.step]?.everCaptured;
    if (evaders) this.#told.textContent = `generation ${this.generation} · ${Array.from(evaders).filter(Boolean).length} of ${evaders.length} caught · step ${this.player.step}`;
  }

  // ---- Walls ------------------------------------------------------------------------------------

  /** Let a finger, a mouse or the keyboard draw walls; `set` gets each cell and whether it becomes a wall, and returns why it does not. Return what begins and ends it. */
  drawWalls(set: (cell: Cell, wall: boolean) => string): (on: boolean) => void {
    let active = false;
    let wall = true;
    let cursor: Cell = [0, 0];
    const isWall = ([row, col]: Cell): boolean => Boolean(this.#recording?.obstacles[row * this.#recording.cols + col]);
    const put = (cell: Cell, wall: boolean): void => void (this.#refused.textContent = set(cell, wall));
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
      active = on;
      this.#canvas.classList.toggle("drawn-on", on);
      this.#canvas.tabIndex = on ? 0 : -1;
      this.#canvas.setAttribute("role", on ? "application" : "img");
      this.#board.look = { cursor: null };
    };
  }

  /** Show walls before a match is played among them. */
  show(walls: Uint8Array): void {
    if (!this.#recording) return;
    this.#recording = { ...this.#recording, obstacles: walls };
    this.#draw();
  }
}
