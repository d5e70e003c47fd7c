// The loupe: where fingers miss a cell of the matrix, a tap shows the cells around it in the size
// of a finger.

import { html } from "../page/dom.ts";
import { cellOf } from "./data.ts";
import type { Run } from "./data.ts";
import { generationName } from "./game.ts";
import { showRate } from "./heatmap.ts";

/** Pixels of a cell that a finger hits. */
const SMALLEST = 24;
/** Cells along a side. */
const ACROSS = 7;

/** Return whether a tap on cells of a size would miss the one that is meant. */
export const needsLoupe = (cell: number): boolean =>
  cell < SMALLEST && matchMedia("(pointer: coarse)").matches;

/** Return the loupe over a cell of a run; `choose` gets the cell that is pressed, or nothing for none. */
export function loupe(
  run: Run,
  g: number,
  h: number,
  choose: (cell: { pursuer: number; evader: number } | null) => void,
): HTMLElement {
  const [rows, columns] = run.payoff.shape;
  const bottom = firstOf(g, rows);
  const left = firstOf(h, columns);
  const high = Math.min(ACROSS, rows);
  const wide = Math.min(ACROSS, columns);
  const cells: HTMLElement[] = [];
  for (let pursuer = bottom + high - 1; pursuer >= bottom; pursuer--) {
    cells.push(html("span", { class: "pursuer" }, pursuer));
    for (let evader = left; evader < left + wide; evader++) {
      cells.push(cellButton(run, pursuer, evader, choose));
    }
  }
  const numbers = Array.from({ length: wide }, (_, column) =>
    html("span", { class: "evader" }, left + column),
  );
  const close = html(
    "button",
    { type: "button", "aria-label": "Close: all cells", onclick: () => choose(null) },
    "✕",
  );
  const keep = (event: Event): void => event.stopPropagation(); // not a tap on the matrix below
  const made = html(
    "div",
    { class: "loupe numbers", role: "group", "aria-label": "Cells around the tap", onclick: keep },
    ...cells,
    close,
    ...numbers,
  );
  made.style.gridTemplateColumns = `2.4rem repeat(${wide}, minmax(0, 1fr))`;
  return made;
}

function cellButton(
  run: Run,
  pursuer: number,
  evader: number,
  choose: (cell: { pursuer: number; evader: number }) => void,
): HTMLElement {
  const button = html("button", { type: "button", onclick: () => choose({ pursuer, evader }) });
  showRate(
    button,
    cellOf(run, pursuer, evader)?.rate,
    `${generationName(run, "pursuer", pursuer)} against ${generationName(run, "evader", evader)}`,
  );
  return button;
}

/** Return the first of the cells around one, all of which exist. */
const firstOf = (middle: number, count: number): number =>
  Math.max(0, Math.min(count - ACROSS, middle - Math.floor(ACROSS / 2)));
