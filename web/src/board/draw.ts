// One picture of a recording at a time, layer by layer.

import { drawAgents } from "./agents.ts";
import { drawBounces, drawPlan } from "./arrows.ts";
import { drawInputs, drawSigns } from "./inputs.ts";
import type { ShownInputs } from "./inputs.ts";
import {
  drawAxes,
  drawContested,
  drawFog,
  drawMarks,
  drawObstacles,
  drawPaper,
  drawRing,
  drawTrails,
  drawView,
  drawYou,
} from "./layers.ts";
import type { Sheet } from "./layers.ts";
import { centreBetween, posesBetween } from "./poses.ts";
import { atFault, cellOf, innocent } from "./recording.ts";
import type { Cell, Numbers, Recording } from "./recording.ts";

/** What to show beside the agents. */
export interface Look {
  /** Numbers of the agents in their teams, where they are readable. */
  readonly numbers: boolean;
  /** Numbers of rows and columns beside the grid. */
  readonly axes: boolean;
  /** Steps that trails go back. */
  readonly trail: number;
  /** Agents whose fields of view are outlined. */
  readonly viewers: readonly number[];
  /** Actions that agents are about to take, drawn while no step is. */
  readonly plan: Numbers | null;
  /** The inputs of a move, drawn while no step is. */
  readonly inputs: ShownInputs | null;
  /** An agent that is marked, and a cell that the keyboard has reached. */
  readonly selected: number | null;
  readonly cursor: Cell | null;
  /** The agent that a person plays, and whether fog covers what it does not see. */
  readonly you: number | null;
  readonly fog: boolean;
}

export const PLAIN: Look = {
  numbers: true,
  axes: false,
  trail: 6,
  viewers: [],
  plan: null,
  inputs: null,
  selected: null,
  cursor: null,
  you: null,
  fog: false,
};

/** Draw a recording at a time: moment 3 at 3, half of step 4 at 3.5. */
export function draw(sheet: Sheet, recording: Recording, time: number, look: Look, ratio: number): void {
  const { ctx, grid, colors } = sheet;
  const step = Math.min(Math.ceil(time), recording.moments.length - 1);
  const moment = recording.moments[step]!;
  const still = time === step;
  const poses = posesBetween(recording, time);
  // Marks of the step that is being drawn grow in its second half.
  const strength = still ? 1 : Math.max(0, 1 - 2 * (step - time));
  ctx.clearRect(0, 0, ctx.canvas.width, ctx.canvas.height);
  drawPaper(sheet);
  for (const agent of look.viewers) {
    if (poses[agent]?.alpha) drawView(sheet, recording, agent, ...centreBetween(recording, agent, time));
  }
  drawObstacles(sheet, recording);
  if (look.axes) drawAxes(sheet, ratio);
  drawTrails(sheet, recording, time, look.trail, poses);
  const inputs = still ? look.inputs : null;
  if (inputs) drawInputs(sheet, recording, inputs);
  drawContested(sheet, moment.contested ?? [], strength);
  drawMarks(sheet, recording, time);
  drawBounces(sheet, recording, step, strength);
  poses.forEach(({ x, y, size }, agent) => {
    const faint = innocent(moment, agent) ? 0.4 : 0;
    const ring = atFault(moment, agent) ? 1 : faint;
    if (ring) drawRing(sheet, x, y, size, ring * strength);
  });
  // What evaders look like changes at the end of a step, when captures are judged.
  const shown = still ? moment : recording.moments[Math.max(0, step - 1)]!;
  drawAgents(sheet, recording, shown, poses, look.numbers, ratio);
  if (inputs) drawSigns(sheet, recording, inputs);
  if (still && look.plan) {
    for (const [agent, pose] of poses.entries()) {
      if (pose.alpha) drawPlan(sheet, recording, agent, cellOf(moment, agent), pose, look.plan[agent] ?? 0);
    }
  }
  if (look.you !== null) {
    if (look.fog) drawFog(sheet, recording, ...centreBetween(recording, look.you, time));
    drawYou(sheet, poses[look.you]!, ratio);
  }
  ctx.lineWidth = Math.max(2, 2.5 * ratio);
  ctx.strokeStyle = colors.focus;
  const chosen = look.selected === null ? undefined : poses[look.selected];
  if (chosen?.alpha) markPlace(sheet, chosen.x, chosen.y, chosen.size * 0.96);
  if (look.cursor) {
    ctx.setLineDash([grid.cell * 0.12, grid.cell * 0.08]);
    markPlace(sheet, look.cursor[1] + 0.5, look.cursor[0] + 0.5, 0.8);
    ctx.setLineDash([]);
  }
}

/** Outline a square around a place, all in cells. */
function markPlace({ ctx, grid }: Sheet, x: number, y: number, size: number): void {
  const side = size * grid.cell;
  ctx.beginPath();
  ctx.roundRect(
    grid.left + x * grid.cell - side / 2,
    grid.top + y * grid.cell - side / 2,
    side,
    side,
    side * 0.1,
  );
  ctx.stroke();
}
