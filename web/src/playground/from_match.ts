// A step of a recorded match in the playground: what if the agents had moved otherwise?

import type { Engine, Match } from "../engine/engine.ts";
import { html } from "../page/dom.ts";
import type { PageData } from "./data.ts";
import { showPlayground } from "./page.ts";
import { MOST_AGENTS, MOST_SIDE, STAY } from "./scene.ts";
import type { Command, Scene, Start } from "./scene.ts";
import { Store } from "./store.ts";

/** Return whether a match fits the playground. */
export function fitsPlayground({ rows, cols, n_pursuers, n_evaders }: Match["config"]): boolean {
  return Math.max(rows, cols) <= MOST_SIDE && Math.max(n_pursuers, n_evaders) <= MOST_AGENTS;
}

/** Return the scene before a step of a match, with what all agents did in that step. */
export function sceneBefore(match: Match, step: number): Scene {
  const { config, n_agents } = match;
  const moment = Math.max(0, Math.min(step, match.length) - 1);
  const starts = Array.from({ length: n_agents }, (_, agent) => startOf(match, moment, agent));
  const actions = match.actions.subarray(moment * n_agents, (moment + 1) * n_agents);
  const next = Array.from({ length: n_agents }, (_, agent): Command => (starts[agent]!.gone ? STAY : actions[agent] ?? STAY));
  return {
    rules: config.rules, others: null, rewards: config.rewards,
    rows: config.rows, cols: config.cols, diagonal: config.diagonal, fov: config.fov, maxSteps: config.max_steps,
    seed: match.seed, episode: BigInt(match.episode), steps: moment, ended: false,
    walls: Array.from(match.map.keys()).filter((cell) => match.map[cell]),
    pursuers: starts.slice(0, config.n_pursuers), evaders: starts.slice(config.n_pursuers),
    played: [], next,
  };
}

function startOf(match: Match, moment: number, agent: number): Start {
  const at = moment * match.n_agents + agent;
  const evader = agent - match.config.n_pursuers;
  const flag = (flags: Uint8Array): boolean => evader >= 0 && Boolean(flags[moment * match.config.n_evaders + evader]);
  return {
    cell: [match.last_positions[2 * at]!, match.last_positions[2 * at + 1]!],
    gone: !match.alive[at],
    captured: flag(match.captured),
    everCaptured: flag(match.ever_captured),
  };
}

/** Open the playground over the page, with a step of a match that can be played again otherwise. */
export function openPlayground(engine: Engine, data: PageData, match: Match, step: number): void {
  const root = html("div");
  const dialog = html("dialog", { class: "whole-page", "aria-label": "Playground" }, root);
  const store = new Store(engine, data, sceneBefore(match, step));
  const end = showPlayground(root, store, () => dialog.close());
  dialog.addEventListener("close", () => {
    store.stop();
    end();
    dialog.remove();
  });
  document.body.append(dialog);
  dialog.showModal();
}
