// Sizes and places on a canvas, in device pixels.

import type { Cell } from "./recording.ts";

/** Where the grid lies on a canvas: the left and top of cell (0, 0), and the side of a cell. */
export interface Geometry {
  readonly rows: number;
  readonly cols: number;
  readonly left: number;
  readonly top: number;
  readonly cell: number;
}

/** Room around the grid, in cells: for marks at the border, and for the numbers of rows and columns. */
const MARGIN = 0.12;
const AXIS = 0.62;
/** Most room for those numbers, in pixels of the page: small grids have large cells. */
const AXIS_PIXELS = 30;

/** Return the width of a board divided by its height. */
export function aspect(rows: number, cols: number, axes: boolean): number {
  const more = 2 * MARGIN + (axes ? AXIS : 0);
  return (cols + more) / (rows + more);
}

/** Return the largest grid that fits a canvas of this size, in the middle of it. */
export function fit(
  rows: number, cols: number, axes: boolean, width: number, height: number, ratio: number,
): Geometry {
  const most = axes ? AXIS_PIXELS * ratio : 0;
  const room = (side: number, cells: number): number =>
    Math.max((side - most) / (cells + 2 * MARGIN), side / (cells + 2 * MARGIN + (axes ? AXIS : 0)));
  // Whole pixels, so that lines between cells are sharp.
  const cell = Math.max(1, Math.floor(Math.min(room(width, cols), room(height, rows))));
  const axis = axes ? Math.min(AXIS * cell, most) : 0;
  return {
    rows, cols, cell,
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
