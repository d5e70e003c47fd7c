/** Settings, starts and policies as the named arrays that web/engine/settings.hpp reads. */

import { expected } from "./errors.ts";
import { Flags } from "./heap.ts";
import type { Inputs } from "./heap.ts";
import { BLAMES, CAPTURES, INPUTS, INTERACTIONS, MAP_CHARACTERS, OUTCOMES, SCRIPTS } from "./tables.ts";
import type {
  Cell,
  Memory,
  Penalty,
  Rewards,
  Rules,
  Snapshot,
  Start,
  TeamPolicy,
  WorldConfig,
} from "./types.ts";

const INT_MAX = 2 ** 31 - 1;
const MEMORIES: readonly Memory[] = ["none", "gru"];
const SEED_MAX = 2n ** 64n - 1n;
const FLOAT_MAX = 3.4028234663852886e38;

// ---- Single values ------------------------------------------------------------------------------

function integer(name: string, value: unknown): Int32Array {
  if (typeof value !== "number" || !Number.isInteger(value) || Math.abs(value) > INT_MAX) {
    throw expected(name, "an integer", value);
  }
  return Int32Array.of(value);
}

function bool(name: string, value: unknown): Flags {
  if (typeof value !== "boolean") throw expected(name, "true or false", value);
  return new Flags(Uint8Array.of(Number(value)));
}

function choice(name: string, value: unknown, numbers: Readonly<Record<string, number>>): Int32Array {
  const number = typeof value === "string" && Object.hasOwn(numbers, value) ? numbers[value] : undefined;
  if (number === undefined) throw expected(name, `one of ${Object.keys(numbers).join(", ")}`, value);
  return Int32Array.of(number);
}

function finite(name: string, value: unknown): number {
  if (typeof value !== "number" || !(Math.abs(value) <= FLOAT_MAX)) {
    throw expected(name, "a finite number", value);
  }
  return value;
}

/** Return an unsigned number of 64 bits, such as a seed. */
export function word(name: string, value: unknown): BigUint64Array {
  const whole = typeof value === "bigint" || (typeof value === "number" && Number.isSafeInteger(value));
  const number = whole ? BigInt(value) : -1n;
  if (number < 0n || number > SEED_MAX) throw expected(name, "an integer from 0 to 2^64 - 1", value);
  return BigUint64Array.of(number);
}

// ---- Settings -----------------------------------------------------------------------------------

function rulesInputs(rules: Rules): Inputs {
  return {
    "rules.interaction": choice("interaction", rules.interaction, INTERACTIONS),
    "rules.obstacle": choice("obstacle", rules.obstacle, OUTCOMES),
    "rules.teammate": choice("teammate", rules.teammate, OUTCOMES),
    "rules.evader": choice("evader", rules.evader, OUTCOMES),
    "rules.pursuer": choice("pursuer", rules.pursuer, OUTCOMES),
    "rules.capture": choice("capture", rules.capture, CAPTURES),
    "rules.captured_disappear": bool("captured_disappear", rules.captured_disappear),
  };
}

function penalties(name: string, value: Penalty): Float32Array {
  const three = typeof value === "number" ? [value, value, value] : value;
  if (!Array.isArray(three) || three.length !== 3) throw expected(name, "1 or 3 numbers", value);
  return Float32Array.from(three, (number) => finite(name, number));
}

function rewardsInputs(rewards: Rewards): Inputs {
  const byTeam = (pursuer: keyof Rewards, evader: keyof Rewards): Float32Array =>
    Float32Array.of(finite(pursuer, rewards[pursuer]), finite(evader, rewards[evader]));
  return {
    "rewards.capture": byTeam("pursuer_capture", "evader_capture"),
    "rewards.neighbor": byTeam("pursuer_neighbor", "evader_neighbor"),
    "rewards.step": byTeam("pursuer_step", "evader_step"),
    "rewards.pursuer_collide": penalties("pursuer_collide", rewards.pursuer_collide),
    "rewards.evader_collide": penalties("evader_collide", rewards.evader_collide),
    "rewards.blame": choice("blame", rewards.blame, BLAMES),
    "rewards.capture_repeats": bool("capture_repeats", rewards.capture_repeats),
  };
}

/** Return the flags (rows * cols) of a map; none for no map. */
function mapOf(given: Start["obstacles"] | WorldConfig["obstacles"]): Uint8Array {
  if (given === undefined || typeof given === "number") return new Uint8Array(0);
  if (given instanceof Uint8Array) return given;
  const { free, blocked } = MAP_CHARACTERS;
  for (const [number, row] of given.entries()) {
    if (row.length !== given[0]?.length) {
      throw expected(`map, row ${number}`, `${given[0]?.length} cells as in row 0`, row.length);
    }
    const unknown = [...row].find((cell) => !free.includes(cell) && !blocked.includes(cell));
    if (unknown) throw expected(`map, row ${number}`, `'${free}' (free) or '${blocked}' (obstacle)`, unknown);
  }
  return Uint8Array.from([...given.join("")], (cell) => Number(blocked.includes(cell)));
}

/** Throw unless rows of text have the size of the world; the engine counts the cells only. */
function checkShape(given: Start["obstacles"] | WorldConfig["obstacles"], config: WorldConfig): void {
  if (!Array.isArray(given)) return;
  const shape = [given.length, given[0]?.length ?? 0];
  if (shape[0] === config.rows && shape[1] === config.cols) return;
  throw expected("obstacle map", `shape (${config.rows}, ${config.cols}), the rows and cols`, shape);
}

/** Return the settings of a world as named arrays. Throws EngineError for a wrong type. */
export function configInputs(config: WorldConfig): Inputs {
  checkShape(config.obstacles, config);
  const density = typeof config.obstacles === "number" ? config.obstacles : 0;
  return {
    ...rulesInputs(config.rules),
    ...rewardsInputs(config.rewards),
    rows: integer("rows", config.rows),
    cols: integer("cols", config.cols),
    n_pursuers: integer("n_pursuers", config.n_pursuers),
    n_evaders: integer("n_evaders", config.n_evaders),
    fov: integer("fov", config.fov),
    diagonal: bool("diagonal", config.diagonal),
    max_steps: integer("max_steps", config.max_steps),
    density: Float64Array.of(density),
    map: mapOf(config.obstacles),
  };
}

// ---- Starts, actions, policies, snapshots -------------------------------------------------------

function cells(name: string, given: readonly Cell[] | undefined): Int32Array {
  return Int32Array.from((given ?? []).flat(), (number) => integer(name, number)[0]!);
}

/** Return a start as named arrays. */
export function startInputs(start: Start, config: WorldConfig): Inputs {
  checkShape(start.obstacles, config);
  return {
    seed: word("seed", start.seed ?? 0n),
    episode: word("episode", start.episode ?? 0),
    pursuers: cells("pursuers", start.pursuers),
    evaders: cells("evaders", start.evaders),
    map: mapOf(start.obstacles),
  };
}

/** Return the actions (A,) as a named array. */
export function actionsInputs(actions: ArrayLike<number>): Inputs {
  return { actions: Int32Array.from(actions, (action) => integer("actions", action)[0]!) };
}

const INPUT_NAMES = Object.keys(INPUTS);

/** Return the number of a named input. */
export function inputNumber(name: string): number {
  const number = INPUT_NAMES.indexOf(name);
  if (number < 0) throw expected("inputs", `names of ${INPUT_NAMES.join(", ")}`, name);
  return number;
}

/** Return a policy as named arrays. */
export function policyInputs(policy: TeamPolicy): Inputs {
  if (typeof policy === "string") {
    if (!Object.hasOwn(SCRIPTS, policy)) {
      throw expected("policy", `one of ${Object.keys(SCRIPTS).join(", ")}`, policy);
    }
    return { script: new TextEncoder().encode(policy) };
  }
  if (policy.kind !== "cells") {
    return {
      inputs: Int32Array.from(policy.inputs, (name) => inputNumber(name)),
      hidden: Int32Array.from(
        policy.kind === "rating" ? policy.hidden : [],
        (size) => integer("hidden", size)[0]!,
      ),
      length: integer("length", policy.kind === "program" ? policy.length : 0),
      mask: new TextEncoder().encode(policy.mask),
      genome: policy.genome,
    };
  }
  if (policy.activation !== "relu" && policy.activation !== "tanh") {
    throw expected("activation", "'relu' or 'tanh'", policy.activation);
  }
  if (!MEMORIES.includes(policy.memory)) {
    throw expected("memory", `one of ${MEMORIES.join(", ")}`, policy.memory);
  }
  return {
    hidden: Int32Array.from(policy.hidden, (size) => integer("hidden", size)[0]!),
    activation: new TextEncoder().encode(policy.activation),
    sampled: bool("sampled", policy.sampled),
    memory: new TextEncoder().encode(policy.memory),
    genome: policy.genome,
  };
}

const SNAPSHOT_FLAGS: readonly (keyof Snapshot)[] = ["first_turn", "terminated", "truncated"];

/** Return a snapshot as named arrays. */
export function snapshotInputs(snapshot: Snapshot): Inputs {
  const inputs: Inputs = { ...snapshot };
  for (const name of SNAPSHOT_FLAGS) inputs[name] = new Flags(snapshot[name] as Uint8Array);
  return inputs;
}
