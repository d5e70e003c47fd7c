// What happens in a scene under some rules: its steps, played by the engine.

import { momentOf, recording } from "../board/from_engine.ts";
import type { Moment, Recording } from "../board/recording.ts";
import type { Engine, Solution, World } from "../engine/engine.ts";
import type { TurnGame } from "../engine/solution.ts";
import { lossesOf } from "../page/solved.ts";
import type { Loss } from "../page/solved.ts";
import type { Conflict, Rules, Snapshot } from "../engine/types.ts";
import { CHAMPION, STAY, agents, configOf, nAgents, standing } from "./scene.ts";
import type { Champions } from "./data.ts";
import type { Command, Scene, Start } from "./scene.ts";

/** The results of one step; those of the start are empty. */
export interface Outcome {
  readonly conflicts: readonly Conflict[];
  /** By agent. */
  readonly rewards: Float32Array;
  /** By evader: how many pursuers took part in its capture in this step. */
  readonly captors: Int32Array;
  readonly terminated: boolean;
  readonly truncated: boolean;
}

/** A scene that is being played under some rules. */
export class Game {
  readonly recording: Recording;
  readonly rules: Rules;
  readonly outcomes: Outcome[] = [];
  #scene: Scene;
  #champions: Champions | undefined;
  #world: World;
  #moments: Moment[] = [];
  #snapshots: Snapshot[] = [];

  /** Throws EngineError if the engine refuses the scene. */
  constructor(engine: Engine, scene: Scene, rules: Rules, champions?: Champions) {
    this.#scene = scene;
    this.#champions = champions;
    this.rules = rules;
    const config = configOf(scene, rules);
    this.#world = engine.world(config);
    this.#world.restore(snapshotOf(this.#world, scene));
    this.recording = recording(config, this.#world.map(), this.#moments);
    this.#keep(undefined);
    for (const commands of scene.played) this.#step(commands);
  }

  /** Play or take back steps until they are those of a scene with the same start; false if it has another. */
  follow(scene: Scene): boolean {
    if (!sameStart(this.#scene, scene)) return false;
    const old = this.#scene.played;
    const common = scene.played.findIndex((commands, step) => commands !== old[step]);
    const kept = common < 0 ? scene.played.length : common;
    // An episode may have ended before the last command.
    const moments = Math.min(kept + 1, this.#moments.length);
    this.#moments.length = this.outcomes.length = this.#snapshots.length = moments;
    this.#world.restore(this.#snapshots.at(-1)!);
    for (const commands of scene.played.slice(moments - 1)) this.#step(commands);
    this.#scene = scene;
    return true;
  }

  /** The number of steps that were played; commands after the end of the episode play none. */
  get length(): number {
    return this.#moments.length - 1;
  }

  get over(): boolean {
    const { terminated, truncated } = this.outcomes.at(-1)!;
    return terminated || truncated;
  }

  /** Return the actions that commands lead to at the present moment. */
  actions(commands: readonly Command[]): Uint8Array {
    const actions = Uint8Array.from(commands, (command) => (typeof command === "number" ? command : STAY));
    const scripts = new Set(commands.filter((command) => typeof command === "string"));
    for (const script of this.over ? [] : scripts) {
      for (const team of ["pursuer", "evader"] as const) {
        const decided = this.#world.decide(
          script === CHAMPION ? this.#champions![team].policy : script,
          team,
          actions,
        );
        commands.forEach((command, agent) => {
          if (command === script && agent < this.#scene.pursuers.length === (team === "pursuer")) {
            actions[agent] = decided[agent]!;
          }
        });
      }
    }
    return actions;
  }

  /** Return a scene that starts at the present moment. */
  scene(): Scene {
    const world = this.#world;
    const cells = world.read("last_positions");
    const alive = world.read("alive");
    const captured = world.read("captured");
    const ever = world.read("ever_captured");
    const first = this.#scene.pursuers.length;
    const starts = agents(this.#scene).map((_, agent): Start => ({
      ...standing([cells[2 * agent]!, cells[2 * agent + 1]!]),
      gone: !alive[agent],
      captured: agent >= first && Boolean(captured[agent - first]),
      everCaptured: agent >= first && Boolean(ever[agent - first]),
    }));
    return {
      ...this.#scene,
      played: [],
      steps: world.steps,
      ended: this.outcomes.at(-1)!.terminated,
      pursuers: starts.slice(0, first),
      evaders: starts.slice(first),
    };
  }

  /** Return perfect play at the present moment, where it is known, and what the last step lost. */
  perfect(solution: Solution): { game: TurnGame | null; losses: readonly Loss[] } {
    const before = this.#snapshots.at(-2);
    const actions = this.#moments.at(-1)!.actions;
    if (before) this.#world.restore(before);
    // The step is played again, and leads to the present moment.
    return {
      losses: before && actions ? lossesOf(solution, this.#world, [actions]) : [],
      game: solution.game(this.#world),
    };
  }

  free(): void {
    this.#world.free();
  }

  #step(commands: readonly Command[]): void {
    if (this.over) return;
    const actions = this.actions(commands);
    this.#world.step(actions);
    this.#keep(actions);
  }

  #keep(actions: Uint8Array | undefined): void {
    const world = this.#world;
    this.#moments.push(momentOf(world, actions));
    this.#snapshots.push(world.snapshot());
    this.outcomes.push({
      conflicts: actions ? world.conflicts() : [],
      rewards: world.read("rewards"),
      captors: world.read("captors"),
      terminated: Boolean(world.read("terminated")[0]),
      truncated: Boolean(world.read("truncated")[0]),
    });
  }
}

/** Return the state of a world at the start of a scene; the engine checks it. */
function snapshotOf(world: World, scene: Scene): Snapshot {
  const starts = agents(scene);
  const indices = starts.map(({ cell }) => cell[0] * scene.cols + cell[1]);
  const evaders = (flag: "captured" | "everCaptured"): Uint8Array =>
    Uint8Array.from(scene.evaders, (evader) => Number(evader[flag]));
  return {
    ...world.snapshot(),
    seed: BigUint64Array.of(scene.seed),
    episode: BigUint64Array.of(scene.episode),
    cells: Int32Array.from(indices, (index, agent) => (starts[agent]!.gone ? -1 : index)),
    last_cells: Int32Array.from(indices, (index, agent) => (starts[agent]!.gone ? index : -1)),
    captured: evaders("captured"),
    ever_captured: evaders("everCaptured"),
    // Paid once; where captures repeat, the engine forgets it at each step.
    capture_paid: evaders("everCaptured"),
    captors: new Int32Array(scene.evaders.length),
    rewards: new Float32Array(nAgents(scene)),
    report: new Int32Array(nAgents(scene)),
    participants: new Int32Array(0),
    steps: Int32Array.of(scene.steps),
    terminated: Uint8Array.of(Number(scene.ended)),
    truncated: Uint8Array.of(Number(scene.steps >= scene.maxSteps)),
  };
}

/** Return whether scenes differ at most in what agents do, and in the rules. */
export function sameStart(a: Scene, b: Scene): boolean {
  const names = Object.keys(a) as (keyof Scene)[];
  return names.every((name) => ["played", "next", "rules", "others"].includes(name) || a[name] === b[name]);
}
