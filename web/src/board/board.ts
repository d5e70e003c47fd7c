// A canvas that shows a recording, as sharp as the screen allows, in the colours of the page's theme.

import { draw, PLAIN } from "./draw.ts";
import type { Look } from "./draw.ts";
import { aspect, cellAt, fit } from "./geometry.ts";
import type { Geometry } from "./geometry.ts";
import { paletteOf } from "./palette.ts";
import { byCell, posesBetween } from "./poses.ts";
import type { Cell, Recording } from "./recording.ts";

/** Return whether the reader asked for as little motion as possible. */
export const stillMotion = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

/**
 * A drawing of a recording at a time.
 *
 *     const board = new Board(document.querySelector("canvas"));
 *     board.show(recording, 3.5);            // half of step 4
 *     board.look = { trail: 0 };
 */
export class Board {
  readonly canvas: HTMLCanvasElement;
  #recording: Recording | null = null;
  #time = 0;
  #look: Look;
  #grid: Geometry = { rows: 1, cols: 1, left: 0, top: 0, cell: 1 };
  #due = 0;

  constructor(canvas: HTMLCanvasElement, look: Partial<Look> = {}) {
    this.canvas = canvas;
    canvas.classList.add("board");
    canvas.setAttribute("role", "img");
    this.#look = { ...PLAIN, ...look };
    new ResizeObserver(() => this.#resize()).observe(canvas);
    // The theme is an attribute of the page.
    new MutationObserver(() => this.redraw()).observe(document.documentElement, { attributes: true });
    addEventListener("beforeprint", () => this.drawNow());
  }

  /** Change what is shown beside the agents. */
  set look(look: Partial<Look>) {
    this.#look = { ...this.#look, ...look };
    this.#shape();
    this.redraw();
  }

  /** Show a recording at a time; drawn with the next frame of the browser. */
  show(recording: Recording, time: number): void {
    this.#recording = recording;
    this.#time = Math.min(Math.max(0, time), recording.moments.length - 1);
    this.#shape();
    this.redraw();
  }

  /** Draw again with the next frame: the theme or the size is another one. */
  redraw(): void {
    if (!this.#due) this.#due = requestAnimationFrame(() => this.drawNow());
  }

  /** Draw at once, as tests and pictures need it. */
  drawNow(): void {
    cancelAnimationFrame(this.#due);
    this.#due = 0;
    const ctx = this.canvas.getContext("2d");
    if (!ctx || !this.#recording) return;
    const { rows, cols } = this.#recording;
    const ratio = devicePixelRatio || 1;
    this.#grid = fit(rows, cols, this.#look.axes, this.canvas.width, this.canvas.height, ratio);
    const sheet = { ctx, grid: this.#grid, colors: paletteOf(this.canvas) };
    draw(sheet, this.#recording, this.#time, this.#look, ratio);
  }

  /** Return the cell at a point of the window, such as that of a pointer event; null outside. */
  cellAt(clientX: number, clientY: number): Cell | null {
    const box = this.canvas.getBoundingClientRect();
    const scale = this.canvas.width / box.width;
    return cellAt(this.#grid, (clientX - box.left) * scale, (clientY - box.top) * scale);
  }

  /** Return the agent nearest to a point of the window on the cell there; null if the cell has none. */
  agentAt(clientX: number, clientY: number): number | null {
    const cell = this.cellAt(clientX, clientY);
    if (!cell || !this.#recording) return null;
    const moment = this.#recording.moments[Math.round(this.#time)]!;
    const here = byCell(this.#recording, moment).get(cell[0] * this.#recording.cols + cell[1]) ?? [];
    const poses = posesBetween(this.#recording, Math.round(this.#time));
    const distance = (agent: number): number => {
      const [x, y] = this.pointOf(poses[agent]!.x, poses[agent]!.y);
      return Math.hypot(x - clientX, y - clientY);
    };
    return here.length ? here.reduce((a, b) => (distance(b) < distance(a) ? b : a)) : null;
  }

  /** Return the point of the window of a place on the grid: (0.5, 0.5) is the middle of cell (0, 0). */
  pointOf(x: number, y: number): [number, number] {
    const box = this.canvas.getBoundingClientRect();
    const scale = box.width / this.canvas.width;
    const { left, top, cell } = this.#grid;
    return [box.left + (left + x * cell) * scale, box.top + (top + y * cell) * scale];
  }

  /** Give the canvas the proportions of the grid, so that the page can lay it out before it is drawn. */
  #shape(): void {
    if (!this.#recording) return;
    const { rows, cols } = this.#recording;
    this.canvas.style.setProperty("--board-aspect", String(aspect(rows, cols)));
  }

  #resize(): void {
    const ratio = devicePixelRatio || 1;
    const { width, height } = this.canvas.getBoundingClientRect();
    this.canvas.width = Math.max(1, Math.round(width * ratio));
    this.canvas.height = Math.max(1, Math.round(height * ratio));
    this.drawNow(); // a canvas that changed its size is empty
  }
}
