// A step of a match in the playground: the same moment, the same actions, and any other rules.

import type { Match } from "../engine/engine.ts";
import { html } from "../page/dom.ts";
import { championsElement } from "../playground/data.ts";
import type { Champions, PageData } from "../playground/data.ts";
import { linkOf } from "../playground/link.ts";
import { MOST_AGENTS, MOST_SIDE } from "../playground/scene.ts";
import type { Scene, Start } from "../playground/scene.ts";
import { bytesOf, text } from "./data.ts";

/** As in `matrixworld.explorer.page`. */
const ENGINE_PLACE = "/* the engine */";

/** What the playground shows: a step of a match, and the champions that play it. */
export interface Shown {
  readonly match: Match;
  readonly step: number;
  readonly champions: Champions;
}

/** Return a button that opens the step that is shown. */
export function playgroundButton(shown: () => Shown | null, data: PageData): HTMLButtonElement {
  return html(
    "button",
    {
      type: "button",
      class: "to-playground",
      title: "Open this step in the playground (G): the same agents and actions under any rules",
      onclick: () => openPlayground(shown(), data),
    },
    "What if?",
  );
}

/** Open the playground over the page, with the step that is shown if it is not too large. */
export function openPlayground(shown: Shown | null, data: PageData): void {
  const fits =
    shown !== null &&
    shown.match.n_agents <= MOST_AGENTS &&
    Math.max(shown.match.config.rows, shown.match.config.cols) <= MOST_SIDE;
  const scene = fits
    ? html("script", { type: "text/plain", id: "scene" }, linkOf(sceneOf(shown.match, shown.step), data))
        .outerHTML
    : "";
  const page = new TextDecoder()
    .decode(bytesOf("playground"))
    .replace(ENGINE_PLACE, () => text("script-engine"))
    .replace("</noscript>", (found) => found + scene + (fits ? championsElement(shown.champions) : ""));
  const frame = html("iframe", { title: "Playground", srcdoc: page });
  const dialog = html(
    "dialog",
    { class: "what-if", "aria-label": "What if?", onclose: () => dialog.remove() },
    html("button", { type: "button", class: "leave", onclick: () => dialog.close() }, "Back to the match"),
    frame,
  );
  document.body.append(dialog);
  dialog.showModal();
}

/** Return the moment before a step, with the actions of that step as what all agents do next. */
function sceneOf(match: Match, step: number): Scene {
  const { config, n_agents } = match;
  const moment = Math.max(0, step - 1);
  const start = (agent: number): Start => {
    const at = moment * n_agents + agent;
    const evader = moment * config.n_evaders + agent - config.n_pursuers;
    const caught = (flags: Uint8Array): boolean => agent >= config.n_pursuers && Boolean(flags[evader]);
    return {
      cell: [match.last_positions[2 * at]!, match.last_positions[2 * at + 1]!],
      gone: !match.alive[at],
      captured: caught(match.captured),
      everCaptured: caught(match.ever_captured),
    };
  };
  const starts = Array.from({ length: n_agents }, (_, agent) => start(agent));
  return {
    rules: config.rules,
    others: null,
    rewards: config.rewards,
    rows: config.rows,
    cols: config.cols,
    diagonal: config.diagonal,
    fov: config.fov,
    maxSteps: config.max_steps,
    seed: match.seed,
    episode: BigInt(match.episode),
    steps: moment,
    ended: moment === match.length,
    walls: Array.from(match.map.keys()).filter((cell) => match.map[cell]),
    pursuers: starts.slice(0, config.n_pursuers),
    evaders: starts.slice(config.n_pursuers),
    played: [],
    next: Array.from(match.actions.subarray(moment * n_agents, (moment + 1) * n_agents)),
  };
}
