// What happened in a step, in words. Sentences about conflicts are the engine's own.

import type { Moment } from "../board/recording.ts";
import { html } from "../page/dom.ts";
import { ACTIONS } from "../page/names.ts";
import { KINDS } from "../engine/tables.ts";
import type { Conflict, Rules } from "../engine/types.ts";
import type { Game } from "./game.ts";
import { agentName, nAgents } from "./scene.ts";
import type { Command, Scene } from "./scene.ts";

export const ARROWS = ["·", "↑", "→", "↓", "←", "↗", "↘", "↙", "↖"];

export const commandText = (command: Command): string =>
  typeof command === "number" ? `${ARROWS[command]} ${ACTIONS[command]}` : command;

/** One line about a step. `used` names the fields of the rules that decided it. */
export interface Line {
  readonly kind: Conflict["kind"] | "capture" | "end" | "calm";
  readonly text: string;
  /** The turn in which it happened, from 1; 0 where all move at once. */
  readonly turn: number;
  /** Who is to blame; empty where that is no question. */
  readonly blame: string;
  /** What a collision that stops nobody costs; empty for others. */
  readonly cost: string;
  readonly used: readonly (keyof Rules)[];
}

const USED: Record<Conflict["kind"], readonly (keyof Rules)[]> = {
  obstacle: ["obstacle"],
  teammate: ["teammate"],
  adversary: ["evader", "pursuer"],
};

const joined = (names: readonly string[]): string =>
  names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`;

/** Return what happened in a step of a game, line by line; at the start there is none. */
export function linesOf(scene: Scene, game: Game, step: number): Line[] {
  const before = game.recording.moments[step - 1];
  const after = game.recording.moments[step];
  const outcome = game.outcomes[step];
  if (!before || !after || !outcome) return [];
  const lines = [
    ...outcome.conflicts.map((conflict) => conflictLine(scene, game.rules, conflict)),
    ...captureLines(scene, before, after, outcome.captors),
  ];
  const calm: Line = {
    kind: "calm",
    text: "No conflict, no capture.",
    turn: 0,
    blame: "",
    cost: "",
    used: [],
  };
  return [...(lines.length ? lines : [calm]), ...endLines(scene, game, step)];
}

function conflictLine(scene: Scene, rules: Rules, conflict: Conflict): Line {
  const guilty = conflict.at_fault.map((agent) => agentName(scene, agent));
  const turn = rules.interaction === "SIMULTANEOUS" ? 0 : conflict.turn + 1;
  const blame = guilty.length ? `At fault: ${joined(guilty)}.` : "Nobody is at fault.";
  const stopped = conflict.held.length + conflict.doomed.length > 0;
  const costs = new Set(
    conflict.at_fault.map((agent) => penaltyOf(scene, agent, KINDS.indexOf(conflict.kind))),
  );
  costs.delete(0);
  const cost =
    stopped || !costs.size ? "" : `Allowed, but it costs: ${[...costs].map(signed).join(" and ")}.`;
  return { kind: conflict.kind, text: `${conflict.text}.`, turn, blame, cost, used: USED[conflict.kind] };
}

/** Return what a collision of a kind costs an agent that is blamed. */
function penaltyOf({ pursuers, rewards }: Scene, agent: number, kind: number): number {
  const penalty = agent < pursuers.length ? rewards.pursuer_collide : rewards.evader_collide;
  return typeof penalty === "number" ? penalty : penalty[kind]!;
}

/** Return a reward with its sign; engine numbers are float32, so that the last digits mean nothing. */
export function signed(reward: number): string {
  const text = String(Number(Math.abs(reward).toPrecision(5)));
  return reward < 0 ? `−${text}` : reward > 0 ? `+${text}` : "0";
}

/**
 * Return the reward of an agent in a step as a sum, such as "−12 collision, −0.05 step"; empty if
 * it has one part.
 */
export function sumOf(scene: Scene, game: Game, step: number, agent: number): string {
  const before = game.recording.moments[step - 1];
  const after = game.recording.moments[step];
  const outcome = game.outcomes[step];
  if (!before?.alive[agent] || !after || !outcome) return "";
  const { rewards } = scene;
  const team = agent < scene.pursuers.length ? "pursuer" : "evader";
  const blamed = rewards.blame === "FAULT" ? after.fault : after.involved;
  const collision = KINDS.reduce(
    (sum, _, kind) => sum + (blamed?.[3 * agent + kind] ? penaltyOf(scene, agent, kind) : 0),
    0,
  );
  // The engine tells the sum alone: what is left is a neighbour, captures, or both.
  const rest = outcome.rewards[agent]! - collision - rewards[`${team}_step`];
  const captures = Array.from(
    { length: scene.evaders.length + 1 },
    (_, count) => count * rewards[`${team}_capture`],
  );
  for (const neighbor of [0, rewards[`${team}_neighbor`]]) {
    const capture = captures.find((each) => Math.abs(each + neighbor - rest) < 1e-4);
    if (capture === undefined) continue;
    const parts = { collision, capture, neighbour: neighbor, step: rewards[`${team}_step`] };
    const shown = Object.entries(parts)
      .filter(([, value]) => value)
      .map(([name, value]) => `${signed(value)} ${name}`);
    return shown.length > 1 ? shown.join(", ") : "";
  }
  return "";
}

function captureLines(scene: Scene, before: Moment, after: Moment, captors: Int32Array): Line[] {
  const lines: Line[] = [];
  for (let evader = 0; evader < scene.evaders.length; evader++) {
    const agent = scene.pursuers.length + evader;
    const name = agentName(scene, agent);
    const gone = before.alive[agent] && !after.alive[agent];
    const by = captors[evader]
      ? ` by ${captors[evader]} ${captors[evader] === 1 ? "pursuer" : "pursuers"}`
      : "";
    const used = ["capture", ...(gone ? ["captured_disappear"] : [])] as (keyof Rules)[];
    if (after.captured[evader] && !before.captured[evader]) {
      lines.push({
        kind: "capture",
        text: `${name} is captured${by}${gone ? " and disappears" : ""}.`,
        turn: 0,
        blame: "",
        cost: "",
        used,
      });
    } else if (before.captured[evader] && !after.captured[evader] && after.alive[agent]) {
      lines.push({
        kind: "capture",
        text: `${name} is free again.`,
        turn: 0,
        blame: "",
        cost: "",
        used: ["capture"],
      });
    }
  }
  return lines;
}

function endLines(scene: Scene, game: Game, step: number): Line[] {
  const { terminated, truncated } = game.outcomes[step]!;
  if (!terminated && !truncated) return [];
  const alive = game.recording.moments[step]!.alive;
  const left = (from: number, to: number): boolean => Array.from(alive).slice(from, to).some(Boolean);
  const first = scene.pursuers.length;
  let reason = `after ${scene.maxSteps} steps`;
  if (terminated) reason = left(0, first) ? "every evader is captured or gone" : "no pursuer is left";
  if (terminated && !left(first, nAgents(scene))) reason = "no evader is left";
  return [{ kind: "end", text: `The episode has ended: ${reason}.`, turn: 0, blame: "", cost: "", used: [] }];
}

/** Return a text for the page, in which cells and names of variants are not broken between lines. */
export function unbroken(text: string): (string | HTMLElement)[] {
  return text
    .split(/(\(-?\d+, -?\d+\)|-[A-Z]{1,3}\b)/)
    .map((part, place) => (place % 2 ? html("span", { class: "whole" }, part) : part));
}
