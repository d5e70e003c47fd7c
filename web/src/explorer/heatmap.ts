// Cells of a payoff matrix on a canvas, pursuer generations upwards.

import type { Payoff } from "./data.ts";
import { rate } from "./format.ts";
import { html } from "../page/dom.ts";
import { inkOn, viridis, viridisGradient, viridisText } from "./colormap.ts";

type Box = Readonly<Record<"left" | "top" | "width" | "height", number>>;

type Cells = Pick<Payoff, "shape" | "first" | "capture_rate">;

/** Draw the capture rates of all cells; cells without episodes stay empty. */
export function drawCells(canvas: HTMLCanvasElement, payoff: Cells, box: Box): void {
  const ratio = devicePixelRatio || 1;
  for (const [name, pixels] of Object.entries(box)) canvas.style.setProperty(name, `${pixels}px`);
  canvas.width = Math.round(box.width * ratio);
  canvas.height = Math.round(box.height * ratio);
  const ctx = canvas.getContext("2d");
  const cells = cellsOf(payoff);
  if (!ctx || !cells) return;
  ctx.imageSmoothingEnabled = false; // a cell is a square of one colour
  ctx.drawImage(cells, 0, 0, canvas.width, canvas.height);
}

/** Return a picture with one pixel for each cell; rows may be short. */
export function cellsOf(payoff: Cells): HTMLCanvasElement | null {
  const [rows, columns] = payoff.shape;
  const picture = document.createElement("canvas");
  picture.width = columns;
  picture.height = rows;
  const ctx = picture.getContext("2d");
  if (!ctx) return null;
  const image = ctx.createImageData(columns, rows);
  payoff.capture_rate.forEach((row, g) =>
    row.forEach((rate, h) => {
      const at = 4 * ((rows - 1 - g - payoff.first[0]) * columns + h + payoff.first[1]);
      image.data.set([...viridis(rate), 255], at);
    }),
  );
  ctx.putImageData(image, 0, 0);
  return picture;
}

/** Show the rate of a cell on a button, in its colour; readers who hear it are told whose it is. */
export function showRate(
  button: HTMLButtonElement,
  value: number | undefined,
  whose: string,
  digits = 2,
): void {
  button.textContent = rate(value, digits);
  button.ariaLabel = `${whose}: ${button.textContent}`;
  if (value !== undefined) {
    button.style.backgroundColor = viridisText(value);
    button.style.color = inkOn(value);
  }
}

/** Return the colours of rates from 0 to 1, and what both ends mean. */
export function scaleOfRates(low: string, high: string): HTMLElement {
  const bar = html("span", { class: "gradient" });
  bar.style.backgroundImage = viridisGradient();
  return html("p", { class: "scale-of-rates small muted" }, low, bar, high);
}
