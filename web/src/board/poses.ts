// Where agents are drawn at a time between two moments, in cells: x to the right, y down.

import { bounced, cellOf, isPursuer, target } from "./recording.ts";
import type { Moment, Recording } from "./recording.ts";

/** The middle of an agent, its size (1: alone on its cell) and how visible it is. */
export type Pose = Record<"x" | "y" | "size" | "alpha", number>;

/** Agents that share a cell stand beside each other: shifts in cells, by how many they are. */
const GRID = [-0.31, 0, 0.31];
const SLOTS: readonly { size: number; at: readonly (readonly [number, number])[] }[] = [
  { size: 1, at: [[0, 0]] },
  {
    size: 0.62,
    at: [
      [-0.2, 0.2],
      [0.2, -0.2],
    ],
  },
  {
    size: 0.54,
    at: [
      [-0.23, 0.22],
      [0.23, 0.22],
      [0, -0.22],
    ],
  },
  {
    size: 0.54,
    at: [
      [-0.23, 0.23],
      [0.23, 0.23],
      [-0.23, -0.23],
      [0.23, -0.23],
    ],
  },
  { size: 0.36, at: GRID.flatMap((y) => GRID.map((x) => [x, y] as const)) },
];
/** How far an agent that bounces leaves its cell, in cells. */
const NUDGE = 0.3;
/** The share of a step in which one agent moves, where agents take turns. */
const SHORTEST_TURN = 0.35;
/** The share of a move after which an agent that disappears begins to fade. */
const FADE = 0.55;

/** Return the agents alive at a moment, by the number of their cell. */
export function byCell(recording: Recording, moment: Moment): Map<number, number[]> {
  const cells = new Map<number, number[]>();
  for (let agent = 0; agent < moment.alive.length; agent++) {
    if (!moment.alive[agent]) continue;
    const [row, col] = cellOf(moment, agent);
    const cell = row * recording.cols + col;
    const here = cells.get(cell);
    if (here) here.push(agent);
    else cells.set(cell, [agent]);
  }
  return cells;
}

/** Return the pose of every agent at a moment; of a gone one, invisible where it disappeared. */
export function posesAt(recording: Recording, moment: Moment): Pose[] {
  const poses = Array.from(moment.alive, (_, agent): Pose => {
    const [row, col] = cellOf(moment, agent);
    return { x: col + 0.5, y: row + 0.5, size: 1, alpha: 0 };
  });
  for (const agents of byCell(recording, moment).values()) {
    const slots = SLOTS[Math.min(agents.length, SLOTS.length) - 1]!;
    agents.forEach((agent, place) => {
      const [right, down] = slots.at[Math.min(place, slots.at.length - 1)]!;
      const pose = poses[agent]!;
      pose.x += right;
      pose.y += down;
      pose.size = slots.size;
      pose.alpha = 1;
    });
  }
  return poses;
}

const smooth = (share: number): number => share * share * (3 - 2 * share);
const mix = (from: number, to: number, share: number): number => from + (to - from) * share;
const clamp = (value: number): number => Math.min(1, Math.max(0, value));

/** Return how much of its own move an agent has made, 0 to 1, at a share of the step. */
export function progress(recording: Recording, agent: number, agents: number, share: number): number {
  const turns = { SIMULTANEOUS: 1, SWARM_TURNS: 2, AGENT_TURNS: agents }[recording.interaction];
  if (turns === 1) return smooth(share);
  const turn = turns === agents ? agent : Number(!isPursuer(recording, agent));
  const length = Math.max(1 / turns, SHORTEST_TURN);
  return smooth(clamp((share - (turn / (turns - 1)) * (1 - length)) / length));
}

/** Return the poses at a time: moment 3 at 3, half of step 4 at 3.5. */
export function posesBetween(recording: Recording, time: number): Pose[] {
  const last = recording.moments.length - 1;
  const start = Math.min(Math.floor(time), last);
  const before = recording.moments[start]!;
  const from = posesAt(recording, before);
  if (start === last || time === start) return from;
  const after = recording.moments[start + 1]!;
  const to = posesAt(recording, after);
  return from.map((pose, agent) => {
    const share = progress(recording, agent, from.length, time - start);
    return blend(before, after, agent, pose, to[agent]!, share);
  });
}

/** Return the middle of an agent's cell at a time, apart from its place in a shared cell. */
export function centreBetween(recording: Recording, agent: number, time: number): [x: number, y: number] {
  const last = recording.moments.length - 1;
  const start = Math.min(Math.floor(time), last);
  const before = recording.moments[start]!;
  const after = recording.moments[Math.min(start + 1, last)]!;
  const share = progress(recording, agent, before.alive.length, time - start);
  const [row, col] = cellOf(before, agent);
  const [toRow, toCol] = cellOf(after, agent);
  return [mix(col, toCol, share) + 0.5, mix(row, toRow, share) + 0.5];
}

function blend(before: Moment, after: Moment, agent: number, a: Pose, b: Pose, share: number): Pose {
  // An agent that disappears moves in its full size, and then fades.
  const leaving = a.alpha > b.alpha;
  const pose = {
    x: mix(a.x, b.x, share),
    y: mix(a.y, b.y, share),
    size: leaving ? a.size : mix(a.size, b.size, share),
    alpha: leaving ? clamp((1 - share) / (1 - FADE)) : mix(a.alpha, b.alpha, share),
  };
  if (bounced(before, after, agent)) {
    const [row, col] = cellOf(before, agent);
    const [toRow, toCol] = target(before, after, agent);
    const nudge = NUDGE * Math.sin(Math.PI * share);
    pose.x += (toCol - col) * nudge;
    pose.y += (toRow - row) * nudge;
  }
  return pose;
}
