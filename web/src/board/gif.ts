// A recording as an animated GIF, drawn in the colours of the page.

import { GIFEncoder, applyPalette } from "gifenc";
import { PLAIN, draw } from "./draw.ts";
import { aspect, fit } from "./geometry.ts";
import { paletteOf } from "./palette.ts";
import type { Palette } from "./palette.ts";
import type { Recording } from "./recording.ts";

/** A film of 10 s: pictures, and how long each is shown in milliseconds (GIF counts hundredths). */
const FRAMES = 125;
const DELAY = 80;
/** Pictures of the last moment, at the end. */
const HELD = 10;
const LONGER_SIDE = 480;
/** Shades between a colour and the paper, for edges and trails. */
const SHADES = [1, 0.8, 0.6, 0.4, 0.2];
/** Pictures after which the page may do other things. */
const AT_ONCE = 5;

/** Return the film of a whole recording; `tell` gets the percentage that is drawn. */
export async function gifOf(recording: Recording, tell: (percent: number) => void): Promise<Blob> {
  const wide = Math.min(1, aspect(recording.rows, recording.cols));
  const [width, height] = [Math.round(LONGER_SIDE * wide), Math.round((LONGER_SIDE * wide) / aspect(recording.rows, recording.cols))];
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  const ctx = canvas.getContext("2d", { willReadFrequently: true })!;
  const colors = paletteOf(document.documentElement);
  const sheet = { ctx, colors, grid: fit(recording.rows, recording.cols, false, width, height, 1) };
  const [palette, gif] = [shadesOf(colors, ctx), GIFEncoder()];
  for (let frame = 0; frame < FRAMES; frame++) {
    const time = Math.min(1, frame / (FRAMES - HELD)) * (recording.moments.length - 1);
    draw(sheet, recording, time, { ...PLAIN, numbers: false }, 1);
    ctx.globalCompositeOperation = "destination-over"; // below what is drawn
    ctx.fillStyle = colors.paper;
    ctx.fillRect(0, 0, width, height);
    ctx.globalCompositeOperation = "source-over";
    gif.writeFrame(applyPalette(ctx.getImageData(0, 0, width, height).data, palette), width, height, { palette, delay: DELAY });
    if (frame % AT_ONCE === 0) {
      tell(Math.round((100 * frame) / FRAMES));
      await new Promise((resolve) => setTimeout(resolve));
    }
  }
  gif.finish();
  return new Blob([gif.bytes() as Uint8Array<ArrayBuffer>], { type: "image/gif" });
}

/** Return the colours of a board, and those between each of them and the paper. */
function shadesOf(colors: Palette, ctx: CanvasRenderingContext2D): number[][] {
  const rgb = (color: string): number[] => {
    ctx.globalAlpha = 1;
    ctx.fillStyle = color;
    ctx.fillRect(0, 0, 1, 1);
    return [...ctx.getImageData(0, 0, 1, 1).data.subarray(0, 3)];
  };
  const paper = rgb(colors.paper);
  return Object.values(colors).map(rgb).flatMap((color) =>
    SHADES.map((share) => color.map((value, i) => Math.round(paper[i]! + share * (value - paper[i]!)))));
}
