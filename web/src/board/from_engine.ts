// Recordings from what the engine returns.

import type { Match, World } from "../engine/engine.ts";
import type { WorldConfig } from "../engine/types.ts";
import type { Moment, Recording } from "./recording.ts";

/** Return a recording of a world of these settings. */
export function recording(config: WorldConfig, obstacles: Uint8Array, moments: readonly Moment[]): Recording {
  const {
    rows,
    cols,
    n_pursuers: nPursuers,
    fov,
    rules: { interaction },
  } = config;
  return { rows, cols, nPursuers, fov, interaction, obstacles, moments };
}

/** Return the present moment of a world; `actions` are those of the step that led to it. */
export function momentOf(world: World, actions?: ArrayLike<number>): Moment {
  return {
    positions: world.read("last_positions"),
    alive: world.read("alive"),
    captured: world.read("captured"),
    everCaptured: world.read("ever_captured"),
    actions,
    involved: world.read("involved"),
    fault: world.read("fault"),
    contested: world.conflicts().map((conflict) => conflict.cell),
  };
}

/** Return the recording of a match: views of its arrays, without copies. */
export function recordingOf(match: Match): Recording {
  const moments = Array.from({ length: match.length + 1 }, (_, step) => momentAt(match, step));
  return recording(match.config, match.map, moments);
}

function momentAt(match: Match, step: number): Moment {
  const agents = match.n_agents;
  const evaders = match.config.n_evaders;
  const row = <Numbers extends Uint8Array | Int32Array>(array: Numbers, at: number, size: number): Numbers =>
    array.subarray(at * size, (at + 1) * size) as Numbers;
  const moment = {
    positions: row(match.last_positions, step, 2 * agents),
    alive: row(match.alive, step, agents),
    captured: row(match.captured, step, evaders),
    everCaptured: row(match.ever_captured, step, evaders),
  };
  if (step === 0) return moment;
  return {
    ...moment,
    actions: row(match.actions, step - 1, agents),
    involved: row(match.involved, step - 1, 3 * agents),
    fault: row(match.fault, step - 1, 3 * agents),
    // Most steps are never drawn, so their conflicts are asked for when they are.
    get contested() {
      return match.conflicts(step).map((conflict) => conflict.cell);
    },
  };
}
