// The layers of a board, each a function that draws one thing; `draw.ts` puts them in order.

import type { Geometry } from "./geometry.ts";
import type { Palette } from "./palette.ts";
import { cellOf, disappeared, isPursuer, newlyCaptured } from "./recording.ts";
import type { Cell, Recording } from "./recording.ts";
import { burst, cross, disc } from "./shapes.ts";

/** What all layers draw on and with. */
export interface Sheet {
  readonly ctx: CanvasRenderingContext2D;
  readonly grid: Geometry;
  readonly colors: Palette;
}

/** Steps until the mark of a capture or a death has faded. */
const MARK_STEPS = 4;
const BURST = 1.6;
const CROSS = 0.95;
/** Cell sizes in pixels below which lines between cells would fill the picture. */
const SMALLEST_GRID = 5;
const TRAIL_WIDTH = 0.16;
/** A trail on a large cell is a line, not a bar: pixels. */
const WIDEST_TRAIL = 9;
/** Trails of the teams lie beside each other. */
const TRAIL_SHIFT = 0.09;
const OLDEST_TRAIL = 0.2;
const NEWEST_TRAIL = 0.75;

export const pixelX = (grid: Geometry, x: number): number => grid.left + x * grid.cell;
export const pixelY = (grid: Geometry, y: number): number => grid.top + y * grid.cell;

export function teamColor(sheet: Sheet, recording: Recording, agent: number): string {
  return isPursuer(recording, agent) ? sheet.colors.pursuer : sheet.colors.evader;
}

/** Write a bold text around a point, with a border of paper of a width. */
export function write(
  { ctx, colors }: Sheet,
  text: string,
  x: number,
  y: number,
  size: number,
  color: string,
  border = 0,
): void {
  ctx.font = `700 ${Math.round(size)}px system-ui, sans-serif`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.strokeStyle = colors.paper;
  ctx.lineWidth = border;
  if (border) ctx.strokeText(text, x, y);
  ctx.fillStyle = color;
  ctx.fillText(text, x, y);
}

/** Paper and lines between cells. */
export function drawPaper({ ctx, grid, colors }: Sheet): void {
  const { left, top, cell, rows, cols } = grid;
  const width = cols * cell;
  const height = rows * cell;
  ctx.fillStyle = colors.paper;
  ctx.fillRect(left, top, width, height);
  if (cell < SMALLEST_GRID) return;
  ctx.fillStyle = colors.line;
  const line = Math.max(1, Math.round(cell / 60));
  for (let col = 1; col < cols; col++) ctx.fillRect(left + col * cell, top, line, height);
  for (let row = 1; row < rows; row++) ctx.fillRect(left, top + row * cell, width, line);
}

/** Obstacles, and the border. */
export function drawObstacles({ ctx, grid, colors }: Sheet, recording: Recording): void {
  const { left, top, cell, rows, cols } = grid;
  ctx.fillStyle = colors.obstacle;
  for (let index = 0; index < rows * cols; index++) {
    if (!recording.obstacles[index]) continue;
    const row = Math.floor(index / cols);
    const col = index % cols;
    ctx.fillRect(left + col * cell, top + row * cell, cell, cell);
  }
  drawFrame({ ctx, grid, colors });
}

/** The border. */
function drawFrame({ ctx, grid: { left, top, cell, rows, cols }, colors }: Sheet): void {
  const frame = Math.min(5, Math.max(2, Math.round(cell / 18)));
  ctx.strokeStyle = colors.frame;
  ctx.lineWidth = frame;
  ctx.strokeRect(left - frame / 2, top - frame / 2, cols * cell + frame, rows * cell + frame);
}

/** Numbers of rows and columns beside the grid; on small cells every fifth. */
export function drawAxes({ ctx, grid, colors }: Sheet, ratio: number): void {
  const { left, top, cell, rows, cols } = grid;
  const every = cell < 24 * ratio ? 5 : 1;
  ctx.font = `500 ${Math.round(Math.min(15 * ratio, Math.max(9 * ratio, cell * 0.32)))}px system-ui, sans-serif`;
  ctx.fillStyle = colors.muted;
  ctx.textBaseline = "alphabetic";
  ctx.textAlign = "center";
  const gap = 5 * ratio + cell / 40;
  for (let col = 0; col < cols; col += every) {
    ctx.fillText(String(col), left + (col + 0.5) * cell, top - gap);
  }
  ctx.textAlign = "right";
  ctx.textBaseline = "middle";
  for (let row = 0; row < rows; row += every) {
    ctx.fillText(String(row), left - gap, top + (row + 0.5) * cell);
  }
}

/** The square around a place that an agent there sees, cut to the grid: left, top, width and height. */
function seenBox(
  { grid }: Sheet,
  recording: Recording,
  x: number,
  y: number,
): [number, number, number, number] {
  const reach = Math.floor(recording.fov / 2) + 0.5;
  const x0 = Math.max(0, x - reach);
  const x1 = Math.min(grid.cols, x + reach);
  const y0 = Math.max(0, y - reach);
  const y1 = Math.min(grid.rows, y + reach);
  return [pixelX(grid, x0), pixelY(grid, y0), (x1 - x0) * grid.cell, (y1 - y0) * grid.cell];
}

/** Fog over all that an agent at a place does not see, also over marks that reach beyond the border. */
export function drawFog(sheet: Sheet, recording: Recording, x: number, y: number): void {
  const { ctx, grid, colors } = sheet;
  ctx.save();
  ctx.beginPath();
  ctx.rect(0, 0, ctx.canvas.width, ctx.canvas.height);
  ctx.rect(...seenBox(sheet, recording, x, y));
  ctx.clip("evenodd");
  ctx.clearRect(0, 0, ctx.canvas.width, ctx.canvas.height);
  ctx.fillStyle = colors.line;
  ctx.fillRect(grid.left, grid.top, grid.cols * grid.cell, grid.rows * grid.cell);
  ctx.restore();
  drawFrame(sheet);
}

/** A square around the agent that a person plays, and the word "You". */
export function drawYou(
  sheet: Sheet,
  { x, y, alpha }: { x: number; y: number; alpha: number },
  ratio: number,
): void {
  const { ctx, grid, colors } = sheet;
  const side = Math.max(grid.cell, 16 * ratio) * 1.06;
  const left = pixelX(grid, x);
  const top = pixelY(grid, y);
  ctx.globalAlpha = Math.max(alpha, 0.6); // where it disappeared, too
  ctx.beginPath();
  ctx.roundRect(left - side / 2, top - side / 2, side, side, side * 0.2);
  ctx.strokeStyle = colors.focus;
  ctx.lineWidth = Math.max(2, 2.5 * ratio);
  ctx.stroke();
  const size = Math.max(11 * ratio, Math.min(18 * ratio, grid.cell * 0.5));
  const below = top - side / 2 < size * 1.2; // on the first rows there is no room above
  const line = top + (below ? 1 : -1) * (side / 2 + size * 0.7);
  ctx.lineJoin = "round";
  write(sheet, "You", left, line, size, colors.ink, size * 0.35);
  ctx.globalAlpha = 1;
}

/** The square that an agent sees, cut to the grid. */
export function drawView(sheet: Sheet, recording: Recording, agent: number, x: number, y: number): void {
  const { ctx, grid } = sheet;
  const box = seenBox(sheet, recording, x, y);
  const color = teamColor(sheet, recording, agent);
  ctx.globalAlpha = 0.11;
  ctx.fillStyle = color;
  ctx.fillRect(...box);
  ctx.globalAlpha = 0.8;
  ctx.strokeStyle = color;
  ctx.lineWidth = Math.max(1, grid.cell / 24);
  ctx.strokeRect(...box);
  ctx.globalAlpha = 1;
}

/** Where agents came from: lines that fade with age. `now` is where they are drawn at the time. */
export function drawTrails(
  sheet: Sheet,
  recording: Recording,
  time: number,
  steps: number,
  now: readonly { x: number; y: number }[],
): void {
  const { ctx, grid } = sheet;
  const end = Math.min(Math.ceil(time), recording.moments.length - 1);
  const last = recording.moments[end]!;
  ctx.lineCap = "round";
  ctx.lineWidth = Math.min(WIDEST_TRAIL, Math.max(1, grid.cell * TRAIL_WIDTH));
  for (let step = Math.max(1, Math.floor(time - steps) + 1); step <= end; step++) {
    const before = recording.moments[step - 1]!;
    const after = recording.moments[step]!;
    const age = Math.max(0, Math.min(1, (time - step) / steps));
    ctx.globalAlpha = NEWEST_TRAIL + (OLDEST_TRAIL - NEWEST_TRAIL) * age;
    for (let agent = 0; agent < after.alive.length; agent++) {
      // A step that is being drawn leads to where its agent is now.
      const moving = step === end && time < end;
      if (!before.alive[agent] || !(last.alive[agent] || moving)) continue;
      const shift = (isPursuer(recording, agent) ? -1 : 1) * TRAIL_SHIFT;
      const [fromRow, fromCol] = cellOf(before, agent);
      const [toRow, toCol] = cellOf(after, agent);
      if (fromRow === toRow && fromCol === toCol) continue;
      const x = moving ? now[agent]!.x : toCol + 0.5;
      const y = moving ? now[agent]!.y : toRow + 0.5;
      ctx.strokeStyle = teamColor(sheet, recording, agent);
      ctx.beginPath();
      ctx.moveTo(pixelX(grid, fromCol + 0.5 + shift), pixelY(grid, fromRow + 0.5 + shift));
      ctx.lineTo(pixelX(grid, x + shift), pixelY(grid, y + shift));
      ctx.stroke();
    }
  }
  ctx.globalAlpha = 1;
}

/** Captures as stars and other deaths as crosses; they fade within some steps. */
export function drawMarks(sheet: Sheet, recording: Recording, time: number): void {
  const now = Math.min(Math.ceil(time), recording.moments.length - 1);
  for (let step = Math.max(1, now - MARK_STEPS + 1); step <= now; step++) {
    const before = recording.moments[step - 1]!;
    const after = recording.moments[step]!;
    // In the step that is being drawn they appear with the contact; then they fade.
    const strength = step > time ? Math.max(0, 1 - 2 * (step - time)) : 1 - (time - step) / MARK_STEPS;
    const captured = newlyCaptured(recording, before, after);
    for (const agent of disappeared(before, after)) {
      if (!captured.includes(agent)) drawDeath(sheet, cellOf(after, agent), strength);
    }
    for (const agent of captured) drawCapture(sheet, cellOf(after, agent), strength);
  }
  sheet.ctx.globalAlpha = 1;
}

function drawCapture({ ctx, grid, colors }: Sheet, [row, col]: Cell, strength: number): void {
  ctx.globalAlpha = strength;
  burst(ctx, pixelX(grid, col + 0.5), pixelY(grid, row + 0.5), Math.max(8, grid.cell * BURST));
  ctx.fillStyle = colors.capture;
  ctx.fill();
  ctx.strokeStyle = colors.ink;
  ctx.lineWidth = Math.max(1, grid.cell / 36);
  ctx.lineJoin = "round";
  ctx.stroke();
}

function drawDeath({ ctx, grid, colors }: Sheet, [row, col]: Cell, strength: number): void {
  ctx.globalAlpha = strength;
  cross(ctx, pixelX(grid, col + 0.5), pixelY(grid, row + 0.5), Math.max(7, grid.cell * CROSS));
  ctx.strokeStyle = colors.collision;
  ctx.lineWidth = Math.max(2, grid.cell * 0.17);
  ctx.lineCap = "round";
  ctx.stroke();
}

/** Cells that agents were in conflict over: a tint and a dashed line. */
export function drawContested({ ctx, grid, colors }: Sheet, cells: readonly Cell[], strength: number): void {
  const inset = Math.max(1, grid.cell * 0.07);
  ctx.strokeStyle = ctx.fillStyle = colors.collision;
  ctx.lineWidth = Math.max(1, grid.cell * 0.05);
  ctx.setLineDash([grid.cell * 0.14, grid.cell * 0.1]);
  for (const [row, col] of cells) {
    // A move into the border is contested outside the grid, where there is no cell to mark.
    if (row < 0 || col < 0 || row >= grid.rows || col >= grid.cols) continue;
    const box = [
      pixelX(grid, col) + inset,
      pixelY(grid, row) + inset,
      grid.cell - 2 * inset,
      grid.cell - 2 * inset,
    ] as const;
    ctx.globalAlpha = 0.2 * strength;
    ctx.fillRect(...box);
    ctx.globalAlpha = strength;
    ctx.strokeRect(...box);
  }
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}

/** A ring around an agent in a collision: strong if it is at fault, faint if not. */
export function drawRing(
  { ctx, grid, colors }: Sheet,
  x: number,
  y: number,
  size: number,
  strength: number,
): void {
  ctx.globalAlpha = strength;
  disc(ctx, pixelX(grid, x), pixelY(grid, y), Math.max(8, grid.cell * size * 1.02));
  ctx.strokeStyle = colors.collision;
  ctx.lineWidth = Math.max(1.5, grid.cell * 0.085 * Math.sqrt(size));
  ctx.stroke();
  ctx.globalAlpha = 1;
}
