/**
 * What crosses between a page and the engine, as plain values.
 *
 * Fields have the names that they have in Python, so that the JSON of a `WorldConfig` is a
 * `WorldConfig` here. A is the number of agents, pursuers first, E that of evaders, T that of steps.
 * Cells are (row, column) from (0, 0) at the top left. A flag is a byte, 0 or 1.
 */

import type { BLAMES, CAPTURES, FORMS, INPUTS, INTERACTIONS, KINDS, OUTCOMES, SCRIPTS } from "./tables.ts";

export type Outcome = keyof typeof OUTCOMES;
export type Interaction = keyof typeof INTERACTIONS;
export type Capture = keyof typeof CAPTURES;
export type Blame = keyof typeof BLAMES;

/** One row of the table of rules. */
export interface Rules {
  interaction: Interaction;
  obstacle: Outcome;
  teammate: Outcome;
  evader: Outcome;
  pursuer: Outcome;
  capture: Capture;
  captured_disappear: boolean;
}

/** One number for collisions of all kinds, or one for obstacles, teammates, adversaries. */
export type Penalty = number | readonly [number, number, number];

export interface Rewards {
  pursuer_capture: number;
  evader_capture: number;
  pursuer_neighbor: number;
  evader_neighbor: number;
  pursuer_collide: Penalty;
  evader_collide: Penalty;
  pursuer_step: number;
  evader_step: number;
  blame: Blame;
  capture_repeats: boolean;
}

/** The settings of a world, as `WorldConfig.to_json` writes them. */
export interface WorldConfig {
  rules: Rules;
  rows: number;
  cols: number;
  n_pursuers: number;
  n_evaders: number;
  fov: number;
  diagonal: boolean;
  max_steps: number;
  /** Share of the cells that become obstacles at a reset, or a map: rows of "." and "#". */
  obstacles: number | readonly string[];
  rewards: Rewards;
}

export type Activation = "relu" | "tanh";
export type Memory = "none" | "gru";

/** A network and one genome: float32, layer by layer the weights (inputs, outputs), then the biases. */
export interface NetworkPolicy {
  kind: "cells";
  hidden: readonly number[];
  activation: Activation;
  /** Whether an action is drawn from the softmax of the outputs, or the first largest is taken. */
  sampled: boolean;
  /** The recurrent layer after the first hidden layer. */
  memory: Memory;
  genome: Float32Array;
}

export type InputName = keyof typeof INPUTS;

/** A policy that rates each move by its named inputs, and takes the best one that the mask allows. */
interface RatesMoves {
  inputs: readonly InputName[];
  mask: "none" | "obstacles" | "right-of-way";
  genome: Float32Array;
}

/**
 * By a small network: layer by layer the weights and the biases; the last sum, which is the rating,
 * has no bias.
 */
export interface RatingPolicy extends RatesMoves {
  kind: "rating";
  /** Without hidden layers, the genome has a weight for each input. */
  hidden: readonly number[];
}

/** By a program of at most so many instructions, as `matrixworld.Program` writes it into a genome. */
export interface ProgramPolicy extends RatesMoves {
  kind: "program";
  length: number;
}

export type GenomePolicy = NetworkPolicy | RatingPolicy | ProgramPolicy;

/** A policy without its genome, of each kind. */
type Without<Policy> = Policy extends unknown
  ? Omit<Policy, "genome"> & { readonly genome_size: number }
  : never;
export type PolicyShape = Without<GenomePolicy>;

export type ScriptName = keyof typeof SCRIPTS;

/** What plays for a team. */
export type TeamPolicy = GenomePolicy | ScriptName;

/** Row and column of an agent. */
export type Cell = readonly [row: number, col: number];

/** What a reset fixes; the rest is drawn from the seed. */
export interface Start {
  /** Seed of the episode, 0 to 2^64 - 1. The default is 0. */
  seed?: bigint;
  /** Number of the episode of that seed. The default is 0. */
  episode?: number | bigint;
  /** First cells of a whole team, all different. */
  pursuers?: readonly Cell[];
  evaders?: readonly Cell[];
  /** A map for this episode only: rows of "." and "#", or flags (rows * cols). */
  obstacles?: readonly string[] | Uint8Array;
}

/** The arrays of a world, by the names and shapes of `matrixworld.array_specs`. */
export interface WorldArrays {
  /** (A, 2), -1 for an agent that is gone */
  positions: Int32Array;
  /** (A, 2), where a gone agent disappeared */
  last_positions: Int32Array;
  /** (A,) */
  alive: Uint8Array;
  /** (E,) captured now, or when it disappeared */
  captured: Uint8Array;
  /** (E,) */
  ever_captured: Uint8Array;
  /** (E,) pursuers that took part in a capture */
  captors: Int32Array;
  /** (A, 3) in a collision with an obstacle, a teammate, an adversary */
  involved: Uint8Array;
  /** (A, 3) at fault in one */
  fault: Uint8Array;
  /** (A,) number of kinds in which it is at fault */
  cost: Float32Array;
  /** (A,) rewards of the last step */
  rewards: Float32Array;
  /** (A,) */
  terminations: Uint8Array;
  /** (A,) */
  truncations: Uint8Array;
  /** () as the seven that follow */
  steps: Int32Array;
  seed: BigUint64Array;
  episode: BigUint64Array;
  terminated: Uint8Array;
  truncated: Uint8Array;
  capture_rate: Float32Array;
  ever_capture_rate: Float32Array;
  /** (2,) pursuers, evaders */
  survival_rate: Float32Array;
  /** (A, 3, fov, fov) evaders, pursuers, obstacles */
  views: Uint8Array;
  /** (3, rows, cols) */
  state: Uint8Array;
  /** (A, n_actions, all named inputs) */
  inputs: Float32Array;
}

export type Kind = (typeof KINDS)[number];
export type Form = (typeof FORMS)[number];

/** A conflict of a step, between two agents or between an agent and an obstacle. */
export interface Conflict {
  kind: Kind;
  /** "vertex": both head for one cell; "edge": they swap; "chain": the second has to stay. */
  form: Form;
  /** The two agents, or the agent that ran into an obstacle. */
  agents: readonly number[];
  /** The common target, or the cell that the first of `agents` headed for. */
  cell: Cell;
  at_fault: readonly number[];
  /** The agents that stay where they are because of this conflict alone. */
  held: readonly number[];
  /** The agents that this conflict removes. */
  doomed: readonly number[];
  /** Turn of the round, from 0. */
  turn: number;
  /** The conflict as a sentence, word for word that of Python. */
  text: string;
}

/** What a network answers to the view of one agent. */
export interface Answer {
  /** (n_actions,) outputs of the network */
  logits: Float32Array;
  /** (n_actions,) softmax of the outputs; the action is drawn from it where `sampled` */
  probabilities: Float32Array;
  /** The action that the agent takes at this moment of this episode. */
  action: number;
  /** What the agent remembers of earlier steps, from -1 to 1; empty without memory. */
  memory: Float32Array;
}

/** How a policy rates the moves of one agent. */
export interface RatedMoves {
  /** Of the policy's inputs, in its order: one number for each move. */
  inputs: readonly Float32Array[];
  /** (n_actions,) */
  ratings: Float32Array;
  /** (n_actions,) flags of the moves that the mask refuses */
  refused: Uint8Array;
}

/** The statistics of an episode, as one episode of `matrixworld.rollout` has them. */
export interface EpisodeStatistics {
  capture_rate: number;
  ever_capture_rate: number;
  captured_fraction: number;
  length: number;
  /** By team: pursuers, evaders. */
  return: Float64Array;
  survivors: Int32Array;
  overlap: Float32Array;
  /** (2, 3) by team and kind */
  collisions: Int32Array;
  faults: Int32Array;
  agent_steps: BigInt64Array;
}

/** The arrays of a recorded episode, as those of `matrixworld.Episode`. */
export interface EpisodeArrays {
  /** (T + 1, A, 2), -1 for an agent that is gone */
  positions: Int32Array;
  /** (T + 1, A, 2), where a gone agent disappeared */
  last_positions: Int32Array;
  /** (T + 1, A) */
  alive: Uint8Array;
  /** (T + 1, E) */
  captured: Uint8Array;
  /** (T + 1, E) */
  ever_captured: Uint8Array;
  /** (T, A); those of gone agents have no meaning */
  actions: Uint8Array;
  /** (T, A) */
  rewards: Float32Array;
  /** (T, A, 3) */
  involved: Uint8Array;
  /** (T, A, 3) */
  fault: Uint8Array;
  /** (rows, cols) */
  map: Uint8Array;
}

/** A world written down between two turns: `World.restore` goes on from it. */
export interface Snapshot {
  turn: Int32Array;
  seed: BigUint64Array;
  episode: BigUint64Array;
  /** (rows * cols) */
  map: Uint8Array;
  /** (A,) row * cols + col; -1 when gone. Several agents may be on one cell. */
  cells: Int32Array;
  /** (A,) where a gone agent disappeared; -1 for a living one */
  last_cells: Int32Array;
  captured: Uint8Array;
  ever_captured: Uint8Array;
  capture_paid: Uint8Array;
  captors: Int32Array;
  rewards: Float32Array;
  report: Int32Array;
  participants: Int32Array;
  steps: Int32Array;
  first_turn: Uint8Array;
  terminated: Uint8Array;
  truncated: Uint8Array;
  /** (A,) what agents remember: since which step, how many numbers, and the numbers of all */
  memory_steps: Int32Array;
  memory_sizes: Int32Array;
  memories: Float32Array;
}
