// What can be taken away from a race: a film of both boards, and a picture with what came out.

import { draw, PLAIN } from "../board/draw.ts";
import { fit } from "../board/geometry.ts";
import { paletteOf } from "../board/palette.ts";
import type { Recording } from "../board/recording.ts";
import { gifOf } from "../page/gif.ts";

/** A match of a board, and what is said of it. */
export interface Shown {
  readonly title: string;
  readonly recording: Recording;
}

const LOOK = { ...PLAIN, numbers: false };
/** Sides of boards and their distance, in pixels, of a film and of a picture; steps of a film at most. */
const FILM = { side: 260, gap: 12, head: 30 };
const CARD = { width: 1200, height: 800, side: 520, gap: 48 };
const MOST_STEPS = 60;

function canvasOf(width: number, height: number): [HTMLCanvasElement, CanvasRenderingContext2D] {
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  return [canvas, canvas.getContext("2d", { willReadFrequently: true })!];
}

/** Return a board as a picture of its own. */
function boardOf({ recording }: Shown, time: number, side: number): HTMLCanvasElement {
  const [canvas, ctx] = canvasOf(side, side);
  const grid = fit(recording.rows, recording.cols, false, side, side, 1);
  draw(
    { ctx, grid, colors: paletteOf(document.querySelector("canvas.board")!) },
    recording,
    Math.min(time, recording.moments.length - 1),
    LOOK,
    1,
  );
  return canvas;
}

function paper(ctx: CanvasRenderingContext2D, font: string): void {
  const style = getComputedStyle(document.body);
  ctx.fillStyle = style.backgroundColor;
  ctx.fillRect(0, 0, ctx.canvas.width, ctx.canvas.height);
  ctx.fillStyle = style.color;
  ctx.font = `${font} ${style.fontFamily}`;
}

/** Return a film of matches side by side, step by step, as the bytes of a GIF. */
export function filmOf(shown: readonly Shown[]): Uint8Array<ArrayBuffer> {
  const { side, gap, head } = FILM;
  const steps = Math.min(MOST_STEPS, Math.max(...shown.map(({ recording }) => recording.moments.length - 1)));
  const [canvas, ctx] = canvasOf(shown.length * side + (shown.length + 1) * gap, head + side + gap);
  return gifOf(
    Array.from({ length: steps + 1 }, (_, step) => {
      paper(ctx, "600 15px");
      shown.forEach((each, place) => {
        const left = gap + place * (side + gap);
        ctx.fillText(each.title, left, 21, side);
        ctx.drawImage(boardOf(each, step, side), left, head);
      });
      return ctx.getImageData(0, 0, canvas.width, canvas.height);
    }),
  );
}

/** Return a picture of a race: the last moments of both boards, what came out, and how to see it. */
export function cardOf(shown: readonly Shown[], lines: readonly string[]): Promise<Blob> {
  const { width, height, side, gap } = CARD;
  const [canvas, ctx] = canvasOf(width, height);
  paper(ctx, "600 30px");
  shown.forEach((each, place) => {
    const left = gap + place * (side + gap + 16);
    ctx.fillText(each.title, left, 60, side);
    ctx.drawImage(boardOf(each, Infinity, side), left, 80);
  });
  lines.forEach((line, number) => {
    ctx.font = ctx.font.replace(/^\S+ \S+/, number < lines.length - 2 ? "500 27px" : "400 19px");
    ctx.fillText(line, gap, 650 + 37 * number, width - 2 * gap);
  });
  return new Promise((resolve) => canvas.toBlob((blob) => resolve(blob!)));
}
