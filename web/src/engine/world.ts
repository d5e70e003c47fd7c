/** One world, to play and to look at: what `matrixworld.World` is in Python. */

import { conflictsOf } from "./conflicts.ts";
import { expected } from "./errors.ts";
import { call, lastOutputs } from "./heap.ts";
import type { Compiled } from "./heap.ts";
import {
  actionsInputs,
  configInputs,
  inputNumber,
  policyInputs,
  snapshotInputs,
  startInputs,
} from "./inputs.ts";
import type { OfTeams, Team } from "./teams.ts";
import type {
  Answer,
  Conflict,
  GenomePolicy,
  NetworkPolicy,
  RatedMoves,
  Snapshot,
  Start,
  TeamPolicy,
  WorldArrays,
  WorldConfig,
} from "./types.ts";

// Worlds that nothing refers to any more give their memory back.
const released = new FinalizationRegistry<readonly [Compiled, number]>(([engine, world]) =>
  engine._world_free(world),
);

/** One world. Arrays that it returns are copies. `Engine.world` makes one. */
export class World {
  readonly config: WorldConfig;
  readonly n_agents: number;
  readonly n_actions: number;
  private readonly engine: Compiled;
  private readonly at: number;
  private freed = false;

  /** Make a world, in its first episode of seed 0. Throws EngineError for settings out of range. */
  constructor(engine: Compiled, config: WorldConfig) {
    this.engine = engine;
    this.config = config;
    this.n_agents = config.n_pursuers + config.n_evaders;
    this.n_actions = config.diagonal ? 9 : 5;
    this.at = call(engine, (block) => engine._world_new(block.arrays(configInputs(config))));
    released.register(this, [engine, this.at], this);
  }

  /** Give the memory back; otherwise that happens some time after the last use. */
  free(): void {
    if (this.freed) return;
    this.freed = true;
    released.unregister(this);
    this.engine._world_free(this.at);
  }

  /** Where it is in the engine's memory. */
  get address(): number {
    if (this.freed) throw expected("world", "one that is in use", "one that was freed");
    return this.at;
  }

  // ---- Play -------------------------------------------------------------------------------------

  /** Start an episode. The world stays as it was if the start is refused. */
  reset(start: Start = {}): void {
    const inputs = startInputs(start, this.config);
    this.call((block) => this.engine._world_reset(this.address, block.arrays(inputs)));
  }

  /** Play one round with the actions (A,) of all agents; those of gone agents are ignored. */
  step(actions: ArrayLike<number>): void {
    const inputs = actionsInputs(actions);
    this.call((block) => this.engine._world_step(this.address, block.arrays(inputs)));
  }

  /** Play the next turn of a round; only the actions of the living `actors` are read. */
  playTurn(actions: ArrayLike<number>): void {
    const inputs = actionsInputs(actions);
    this.call((block) => this.engine._world_play_turn(this.address, block.arrays(inputs)));
  }

  /**
   * Return the actions (A,) with those that a policy chooses now for the living ones among the agents
   * [first, last) of one team; other entries are those of `actions`. It uses the random numbers of a
   * match for the same seed, episode and step.
   */
  decide(
    policy: TeamPolicy,
    agents: Team | readonly [first: number, last: number],
    given: ArrayLike<number>,
  ): Uint8Array {
    const { n_pursuers } = this.config;
    const teams = { pursuer: [0, n_pursuers], evader: [n_pursuers, this.n_agents] } as const;
    const [first, last] = typeof agents === "string" ? teams[agents] : agents;
    if (given.length !== this.n_agents) throw expected("actions", String(this.n_agents), given.length);
    const inputs = [policyInputs(policy), actionsInputs(given)] as const;
    const { actions } = this.call((block) =>
      this.engine._world_decide(this.address, block.arrays(inputs[0]), first, last, block.arrays(inputs[1])),
    );
    return Uint8Array.from(actions as Int32Array);
  }

  /**
   * Play a round of known actions. Agents whose policies have memory remember it, as when they
   * chose them.
   */
  replay(actions: ArrayLike<number>, policies: OfTeams<TeamPolicy>): void {
    const remembers = (policy: TeamPolicy): boolean =>
      typeof policy !== "string" && policy.kind === "cells" && policy.memory !== "none";
    if (!remembers(policies.pursuer) && !remembers(policies.evader)) return this.step(actions);
    const { n_pursuers } = this.config;
    for (let turn = this.n_turns; turn > 0; --turn) {
      const [first, last] = this.actors;
      if (first < n_pursuers) this.decide(policies.pursuer, [first, Math.min(last, n_pursuers)], actions);
      if (last > n_pursuers) this.decide(policies.evader, [Math.max(first, n_pursuers), last], actions);
      this.playTurn(actions);
    }
  }

  // ---- Look -------------------------------------------------------------------------------------

  /** Turns in a round: 1 where all agents move at once, 2 for teams, A for single agents. */
  get n_turns(): number {
    return this.turnNumbers()[1]!;
  }

  /** Number of the next turn, from 0. */
  get turn(): number {
    return this.turnNumbers()[0]!;
  }

  /** The agents [first, last) that act in the next turn. */
  get actors(): readonly [first: number, last: number] {
    const [, , first, last] = this.turnNumbers();
    return [first!, last!];
  }

  private turnNumbers(): Int32Array {
    return this.call(() => this.engine._world_turn(this.address))["turn"] as Int32Array;
  }

  /** Rounds played in this episode. */
  get steps(): number {
    return this.read("steps")[0]!;
  }

  get seed(): bigint {
    return this.read("seed")[0]!;
  }

  get episode(): bigint {
    return this.read("episode")[0]!;
  }

  /** Whether the episode has ended, by captures or at max_steps. */
  get over(): boolean {
    return this.read("terminated")[0] === 1 || this.read("truncated")[0] === 1;
  }

  /** Return one array. */
  read<Name extends keyof WorldArrays>(name: Name): WorldArrays[Name] {
    return this.call((block) => this.engine._world_read(this.address, block.text(name)))[
      name
    ] as WorldArrays[Name];
  }

  /** Return the view of one agent, (3, fov, fov): evaders, pursuers, obstacles. */
  view(agent: number): Uint8Array {
    const size = 3 * this.config.fov ** 2;
    return this.read("views").slice(agent * size, (agent + 1) * size);
  }

  /** Return the obstacles of this episode, (rows, cols). */
  map(): Uint8Array {
    return this.read("state").slice(2 * this.config.rows * this.config.cols);
  }

  /** Return the conflicts of the last round (of its turns so far, in the middle of one). */
  conflicts(): Conflict[] {
    return conflictsOf(this.conflictTable(), this.config.n_pursuers);
  }

  /** Return the same as numbers (n, 11), those of `Match`. */
  conflictTable(): Int32Array {
    return this.call(() => this.engine._world_conflicts(this.address))["conflict_table"] as Int32Array;
  }

  /** Return what a network answers to the view of a living agent. */
  answer(policy: NetworkPolicy, agent: number): Answer {
    const inputs = policyInputs(policy);
    const { logits, memory } = this.call((block) =>
      this.engine._world_logits(this.address, block.arrays(inputs), agent),
    );
    const outputs = logits as Float32Array;
    const action = this.decide(policy, [agent, agent + 1], new Uint8Array(this.n_agents))[agent]!;
    return { logits: outputs, probabilities: softmax(outputs), action, memory: memory as Float32Array };
  }

  /** Return how a policy rates the moves of a living agent. */
  rate(policy: Exclude<GenomePolicy, NetworkPolicy>, agent: number): RatedMoves {
    const given = policyInputs(policy);
    const { ratings, refused } = this.call((block) =>
      this.engine._world_rate(this.address, block.arrays(given), agent),
    );
    const all = this.read("inputs");
    const n_inputs = all.length / this.n_agents / this.n_actions;
    const of = (input: number): Float32Array =>
      Float32Array.from(
        { length: this.n_actions },
        (_, move) => all[(agent * this.n_actions + move) * n_inputs + input]!,
      );
    return {
      inputs: policy.inputs.map((name) => of(inputNumber(name))),
      ratings: ratings as Float32Array,
      refused: refused as Uint8Array,
    };
  }

  // ---- Moments ----------------------------------------------------------------------------------

  /** Return the whole state, from which any world of these settings can go on. */
  snapshot(): Snapshot {
    return this.call(() => this.engine._world_snapshot(this.address)) as unknown as Snapshot;
  }

  /** Go on from a state, which may be an edited one. The world stays as it was if it is refused. */
  restore(snapshot: Snapshot): void {
    const inputs = snapshotInputs(snapshot);
    this.call((block) => this.engine._world_restore(this.address, block.arrays(inputs)));
  }

  private call(invoke: Parameters<typeof call>[1]): ReturnType<typeof lastOutputs> {
    call(this.engine, invoke);
    return lastOutputs(this.engine);
  }
}

function softmax(logits: Float32Array): Float32Array {
  const largest = Math.max(...logits);
  const weights = Array.from(logits, (logit) => Math.exp(logit - largest));
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  return Float32Array.from(weights, (weight) => weight / total);
}
