// Matches that grow while they are played: by a person in one seat, or from recorded actions.

import { momentOf, recording } from "../board/from_engine.ts";
import type { Moment, Recording } from "../board/recording.ts";
import type { Engine, Solution, World } from "../engine/engine.ts";
import type { TurnGame } from "../engine/solution.ts";
import type { Team } from "../engine/teams.ts";
import type { Conflict, Start, TeamPolicy, WorldConfig } from "../engine/types.ts";
import type { Told } from "../explorer/words.ts";

/** What moves an agent: the action of a person, or a policy. */
export type Hand = number | TeamPolicy;

/** A match and all moments of it so far. */
export class Live implements Told {
  readonly config: WorldConfig;
  readonly start: Start;
  readonly recording: Recording;
  /** Of each step, the actions of all agents. */
  readonly actions: Uint8Array[] = [];
  readonly #world: World;
  readonly #moments: Moment[];
  readonly #conflicts: Conflict[][] = [[]];

  constructor(engine: Engine, config: WorldConfig, start: Start) {
    this.config = config;
    this.start = start;
    this.#world = engine.world(config);
    this.#world.reset(start);
    this.#moments = [momentOf(this.#world)];
    this.recording = recording(config, this.#world.map(), this.#moments);
  }

  get length(): number {
    return this.actions.length;
  }

  get over(): boolean {
    return this.#world.over;
  }

  get statistics(): { capture_rate: number } {
    return { capture_rate: this.#world.read("capture_rate")[0]! };
  }

  conflicts(step: number): readonly Conflict[] {
    return this.#conflicts[step]!;
  }

  /** Return perfect play at the present moment, where it is known. */
  game(solution: Solution): TurnGame | null {
    return solution.game(this.#world);
  }

  /** Play a step with the actions of all agents. */
  play(actions: Uint8Array): void {
    this.#world.step(actions);
    this.#keep(actions);
  }

  /** Play a step in which a hand moves the agent in a seat, and policies move all others. */
  step(policies: Readonly<Record<Team, TeamPolicy>>, seat: number, hand: Hand): void {
    const world = this.#world;
    const first_evader = this.config.n_pursuers;
    let actions: Uint8Array = new Uint8Array(world.n_agents);
    // As in every match of the engine, agents decide at the beginning of their own turn.
    for (let turn = world.n_turns; turn > 0 && !world.over; --turn) {
      const [first, last] = world.actors;
      if (first < first_evader) {
        actions = world.decide(policies.pursuer, [first, Math.min(last, first_evader)], actions);
      }
      if (last > first_evader) {
        actions = world.decide(policies.evader, [Math.max(first, first_evader), last], actions);
      }
      if (typeof hand === "number") actions[seat] = hand;
      else if (first <= seat && seat < last) actions = world.decide(hand, [seat, seat + 1], actions);
      world.playTurn(actions);
    }
    this.#keep(actions);
  }

  #keep(actions: Uint8Array): void {
    this.actions.push(actions);
    this.#moments.push(momentOf(this.#world, actions));
    this.#conflicts.push(this.#world.conflicts());
  }
}

/** Return the match of recorded actions. */
export function replayed(
  engine: Engine,
  config: WorldConfig,
  start: Start,
  actions: readonly Uint8Array[],
): Live {
  const live = new Live(engine, config, start);
  for (const each of actions) live.play(each);
  return live;
}
