// Sizes and places on a canvas, in device pixels.

import type { Cell } from "./recording.ts";

/** Where the grid lies on a canvas: the left and top of cell (0, 0), and the side of a cell. */
export type Geometry = Readonly<Record<"rows" | "cols" | "left" | "top" | "cell", number>>;

/** Room around the grid for marks at the border, in cells. */
const MARGIN = 0.12;
/** Room for the numbers of rows and columns, in pixels of the page. */
const AXIS = 28;

/** Return the width of a board divided by its height. */
export const aspect = (rows: number, cols: number): number => (cols + 2 * MARGIN) / (rows + 2 * MARGIN);

/** Return the largest grid that fits a canvas of this size, in the middle of it. */
export function fit(
  rows: number,
  cols: number,
  axes: boolean,
  width: number,
  height: number,
  ratio: number,
): Geometry {
  const axis = axes ? AXIS * ratio : 0;
  const room = (side: number, cells: number): number => (side - axis) / (cells + 2 * MARGIN);
  // Whole pixels, so that lines between cells are sharp.
  const cell = Math.max(1, Math.floor(Math.min(room(width, cols), room(height, rows))));
  return {
    rows,
    cols,
    cell,
    left: Math.round((width - cols * cell + axis) / 2),
    top: Math.round((height - rows * cell + axis) / 2),
  };
}

/** Return the cell at a point of the canvas, or null outside the grid. */
export function cellAt(grid: Geometry, x: number, y: number): Cell | null {
  const row = Math.floor((y - grid.top) / grid.cell);
  const col = Math.floor((x - grid.left) / grid.cell);
  return row >= 0 && row < grid.rows && col >= 0 && col < grid.cols ? [row, col] : null;
}
