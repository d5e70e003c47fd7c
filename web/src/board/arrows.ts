// The layers of moves: those that were held, and those that agents are about to make.

import { pixelX, pixelY, teamColor } from "./layers.ts";
import type { Sheet } from "./layers.ts";
import type { Pose } from "./poses.ts";
import { MOVES, bounced, cellOf, isCell, target } from "./recording.ts";
import type { Cell, Recording } from "./recording.ts";
import { arrow } from "./shapes.ts";

/** Where arrows start and end, as shares of a move; the border leaves less room. */
const START = 0.46;
const END = 0.86;
const END_OUTSIDE = 0.66;
const HELD_START = 0.48;
const HELD_END = 0.78;
const HELD_OUTSIDE = 0.58;

/** Moves of a step that were held: dashed arrows that end at a bar. */
export function drawBounces(sheet: Sheet, recording: Recording, step: number, strength: number): void {
  const before = recording.moments[step - 1];
  const after = recording.moments[step]!;
  if (!before) return;
  const { ctx, grid, colors } = sheet;
  ctx.strokeStyle = colors.collision;
  ctx.lineWidth = Math.max(1.5, grid.cell * 0.07);
  ctx.lineCap = "butt";
  ctx.globalAlpha = strength;
  for (let agent = 0; agent < after.alive.length; agent++) {
    if (bounced(before, after, agent)) {
      drawHeld(sheet, recording, cellOf(before, agent), target(before, after, agent));
    }
  }
  ctx.globalAlpha = 1;
}

function drawHeld({ ctx, grid }: Sheet, recording: Recording, from: Cell, to: Cell): void {
  const dx = to[1] - from[1];
  const dy = to[0] - from[0];
  const x = (share: number): number => pixelX(grid, from[1] + 0.5 + dx * share);
  const y = (share: number): number => pixelY(grid, from[0] + 0.5 + dy * share);
  const end = isCell(recording, to) ? HELD_END : HELD_OUTSIDE;
  ctx.setLineDash([grid.cell * 0.09, grid.cell * 0.06]);
  ctx.beginPath();
  ctx.moveTo(x(HELD_START), y(HELD_START));
  ctx.lineTo(x(end), y(end));
  ctx.stroke();
  ctx.setLineDash([]);
  const bar = (0.17 * grid.cell) / Math.hypot(dx, dy);
  ctx.beginPath();
  ctx.moveTo(x(end) - dy * bar, y(end) + dx * bar);
  ctx.lineTo(x(end) + dy * bar, y(end) - dx * bar);
  ctx.stroke();
}

/** The move that an agent, drawn at a pose, is about to make from its cell. */
export function drawPlan(
  sheet: Sheet,
  recording: Recording,
  agent: number,
  cell: Cell,
  pose: Pose,
  action: number,
): void {
  const move = MOVES[action];
  if (!action || !move) return;
  const { ctx, grid, colors } = sheet;
  const end = isCell(recording, [cell[0] + move[0], cell[1] + move[1]]) ? END : END_OUTSIDE;
  const start = START * pose.size;
  // Agents that share a cell have arrows beside each other.
  const points = [
    pixelX(grid, pose.x + move[1] * start),
    pixelY(grid, pose.y + move[0] * start),
    pixelX(grid, pose.x + move[1] * end),
    pixelY(grid, pose.y + move[0] * end),
  ] as const;
  const width = Math.max(1.5, grid.cell * 0.085);
  ctx.lineCap = ctx.lineJoin = "round";
  // A wide line of paper below keeps arrows apart from what they cross.
  for (const [color, wide] of [
    [colors.paper, width * 2.1],
    [teamColor(sheet, recording, agent), width],
  ] as const) {
    ctx.strokeStyle = color;
    ctx.lineWidth = wide;
    arrow(ctx, ...points, grid.cell * 0.2);
    ctx.stroke();
  }
}
