// The layer of the agents: triangles that pursue and discs that evade, hollow when captured.

import { byCell } from "./poses.ts";
import type { Pose } from "./poses.ts";
import { isPursuer } from "./recording.ts";
import type { Moment, Recording } from "./recording.ts";
import { pixelX, pixelY, teamColor, write } from "./layers.ts";
import type { Sheet } from "./layers.ts";
import { disc, triangle } from "./shapes.ts";

/** Size of an agent in cells; a triangle as wide as a disc looks smaller. */
const DISC = 0.8;
const TRIANGLE = 0.92;
/** Sizes in pixels of the page below which a number, or the light border of an agent, is unreadable. */
const SMALLEST_NUMBER = 15;
const SMALLEST_HALO = 7;
/** More agents on a cell than it has places: a number tells how many. */
const PLACES = 9;

/** Draw all agents where they are; `moment` says which evaders are captured. */
export function drawAgents(
  sheet: Sheet,
  recording: Recording,
  moment: Moment,
  poses: readonly Pose[],
  numbers: boolean,
  ratio: number,
): void {
  poses.forEach((pose, agent) => {
    if (pose.alpha > 0) drawAgent(sheet, recording, moment, agent, pose, numbers, ratio);
  });
  sheet.ctx.globalAlpha = 1;
  for (const agents of byCell(recording, moment).values()) {
    if (agents.length > PLACES) drawCount(sheet, poses[agents[PLACES - 1]!]!, agents.length - PLACES + 1);
  }
}

function drawAgent(
  sheet: Sheet,
  recording: Recording,
  moment: Moment,
  agent: number,
  pose: Pose,
  numbers: boolean,
  ratio: number,
): void {
  const { ctx, grid, colors } = sheet;
  const pursuer = isPursuer(recording, agent);
  const x = pixelX(grid, pose.x);
  const y = pixelY(grid, pose.y);
  const size = Math.max(4, grid.cell * pose.size * (pursuer ? TRIANGLE : DISC));
  const color = teamColor(sheet, recording, agent);
  const captured = !pursuer && Boolean(moment.captured[agent - recording.nPursuers]);
  ctx.globalAlpha = pose.alpha;
  (pursuer ? triangle : disc)(ctx, x, y, size);
  if (size > SMALLEST_HALO * ratio) {
    ctx.strokeStyle = colors.paper;
    ctx.lineWidth = Math.max(2, size * 0.1);
    ctx.stroke();
  }
  ctx.fillStyle = captured ? colors.paper : color;
  ctx.fill();
  if (captured) {
    disc(ctx, x, y, size * 0.82);
    ctx.strokeStyle = color;
    ctx.lineWidth = size * 0.18;
    ctx.stroke();
  }
  if (!numbers || size < SMALLEST_NUMBER * ratio) return;
  const text = String(pursuer ? agent : agent - recording.nPursuers);
  const high = size * (pursuer ? 0.4 : 0.5) * (text.length > 1 ? 0.8 : 1);
  write(sheet, text, x, y + size * (pursuer ? 0.17 : 0.03), high, captured ? color : colors.paper);
}

function drawCount(sheet: Sheet, pose: Pose, count: number): void {
  const { cell } = sheet.grid;
  write(
    sheet,
    `+${count}`,
    pixelX(sheet.grid, pose.x),
    pixelY(sheet.grid, pose.y),
    cell * 0.3,
    sheet.colors.ink,
    cell * 0.1,
  );
}
