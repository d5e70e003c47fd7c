// The state of the page: the scene, the games that play it, and what the reader has chosen.

import { Player } from "../board/player.ts";
import { stillMotion } from "../board/board.ts";
import { EngineError } from "../engine/engine.ts";
import type { Engine, Solution } from "../engine/engine.ts";
import type { Rules } from "../engine/types.ts";
import type { Example, PageData } from "./data.ts";
import { Game, sameStart } from "./game.ts";
import { scoreOf, solved } from "../page/solved.ts";
import { MOST_STEPS, agents, configOf, stepped, steppedBack } from "./scene.ts";
import type { Command, Scene } from "./scene.ts";

export type Mode = "act" | "build";

/** A part of the page that shows the store. */
export interface Control {
  readonly element: HTMLElement;
  readonly update: () => void;
}

/** Seconds of a step as it is drawn: turns are drawn one after the other. */
const SECONDS: Record<Rules["interaction"], number> = {
  SIMULTANEOUS: 0.45,
  SWARM_TURNS: 0.9,
  AGENT_TURNS: 1.4,
};
const MOST_UNDONE = 200;

/** Dispatches `change` when anything has changed, and `message` with a text for the reader. */
export class Store extends EventTarget {
  readonly data: PageData;
  readonly player: Player;
  #engine: Engine;
  #scene: Scene;
  #games: Game[];
  #undo: Scene[] = [];
  #redo: Scene[] = [];
  /** Commands of steps that were taken back, the next one last: stepping plays them again. */
  #later: (readonly Command[])[] = [];
  #running = false;
  #mode: Mode = "act";
  #selected: number | null = 0;
  #example: Example | null = null;
  /** The scene of the example, as it was chosen. */
  #original: Scene;

  /** Throws EngineError if the engine refuses the scene. */
  constructor(engine: Engine, data: PageData, scene: Scene, example: Example | null = null) {
    super();
    this.#engine = engine;
    this.data = data;
    this.#example = example;
    this.#scene = this.#original = scene;
    this.#games = this.#played(scene);
    this.player = new Player(this.game.length, { still: stillMotion() });
    this.player.jump(this.game.length);
    this.player.addEventListener("frame", () => this.#continue());
    this.#aim();
  }

  get scene(): Scene {
    return this.#scene;
  }

  /** The game under the scene's rules, and all games: a second one has the rules to compare with. */
  get game(): Game {
    return this.#games[0]!;
  }

  get games(): readonly Game[] {
    return this.#games;
  }

  get mode(): Mode {
    return this.#mode;
  }

  set mode(mode: Mode) {
    this.stop();
    this.#mode = mode;
    this.#emit();
  }

  get selected(): number | null {
    return this.#selected;
  }

  set selected(agent: number | null) {
    this.#selected = agent;
    this.#emit();
  }

  get running(): boolean {
    return this.#running;
  }

  /** The example of the gallery that the scene starts from, whatever agents do and under any rules. */
  get example(): Example | null {
    return sameStart(this.#original, this.#scene) ? this.#example : null;
  }

  get canStep(): boolean {
    return !this.game.over && this.#scene.played.length < MOST_STEPS;
  }

  /**
   * Show another scene; a scene that the engine refuses is not shown, and its reason is told.
   * `part`: whether it continues the last change, such as a drag, and is undone with it.
   */
  change(scene: Scene, options: { part?: boolean; example?: Example | null } = {}): boolean {
    let games: Game[];
    try {
      games = this.#played(scene);
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
      this.say(error.message, true);
      return false;
    }
    if (!options.part) this.#undo = [...this.#undo, this.#scene].slice(-MOST_UNDONE);
    this.#redo = [];
    if (options.example !== undefined) {
      this.#example = options.example;
      this.#original = scene;
    }
    this.#later = [];
    this.#show(scene, games);
    return true;
  }

  /** Play a step: that which was taken back, or a new one. */
  step(): void {
    if (!this.canStep) {
      this.stop();
      this.say(
        this.game.over
          ? "The episode has ended. Go back, or restart."
          : `The playground plays ${MOST_STEPS} steps.`,
        true,
      );
      return;
    }
    const again = this.#later.at(-1) === this.#scene.next;
    const later = again ? this.#later.slice(0, -1) : [];
    const next = stepped(this.#scene);
    this.change({ ...next, next: later.at(-1) ?? next.next });
    this.#later = later;
  }

  /** Take the last step back. */
  back(): void {
    this.stop();
    const { played } = this.#scene;
    if (!this.game.length) return;
    // Commands after the end of the episode played no step; they are taken back with the last one.
    let scene = this.#scene;
    const later = this.#later.at(-1) === scene.next ? [...this.#later] : [];
    for (let step = played.length; step >= this.game.length; step--) {
      scene = steppedBack(scene);
      later.push(scene.next);
    }
    this.change(scene);
    this.#later = later;
  }

  /** Go back to the start; stepping plays the same steps again. */
  restart(): void {
    this.stop();
    const { played } = this.#scene;
    if (!played.length) return;
    const later = [...(this.#later.at(-1) === this.#scene.next ? this.#later : []), ...[...played].reverse()];
    this.change({ ...this.#scene, played: [], next: played[0]! });
    this.#later = later;
  }

  /** Play steps until the episode ends or the reader stops it. */
  run(): void {
    if (this.#running) return this.stop();
    this.#running = this.canStep;
    this.step();
  }

  stop(): void {
    if (!this.#running) return;
    this.#running = false;
    this.#emit();
  }

  undo(): void {
    this.#exchange(this.#undo, this.#redo);
  }

  redo(): void {
    this.#exchange(this.#redo, this.#undo);
  }

  /** Solve the world of the scene; null where it is not solved. */
  solution(): Promise<Solution | null> {
    const config = configOf(this.#scene, this.#scene.rules);
    return solved(this.#engine, config, scoreOf(config));
  }

  get canUndo(): boolean {
    return this.#undo.length > 0;
  }

  /** Let `update` show the store, now and after each change, and after each step or picture of the player. */
  shownBy(update: () => void, type: "step" | "frame" = "step"): void {
    this.addEventListener("change", update);
    this.player.addEventListener(type, update);
    update();
  }

  /** Tell the reader something; it stays until the next change. */
  say(text: string, problem = false): void {
    this.dispatchEvent(new CustomEvent("message", { detail: { text, problem } }));
  }

  #exchange(from: Scene[], to: Scene[]): void {
    const scene = from.pop();
    if (!scene) return;
    this.stop();
    to.push(this.#scene);
    this.#later = [];
    this.#show(scene, this.#played(scene));
  }

  /** Return the games of a scene; games of the same start and rules go on. */
  #played(scene: Scene): Game[] {
    const rows = scene.others ? [scene.rules, scene.others] : [scene.rules];
    const old = this.#games ?? [];
    return rows.map((rules) => {
      const game = old.find((each) => each.rules === rules);
      const found = game?.follow(scene) ? game : new Game(this.#engine, scene, rules, this.data.champions);
      found.actions(scene.next); // the engine refuses a network that does not fit the scene
      return found;
    });
  }

  #show(scene: Scene, games: Game[]): void {
    const old = this.#scene;
    const others = this.#games.length;
    for (const game of this.#games) {
      if (!games.includes(game)) game.free();
    }
    this.#scene = scene;
    this.#games = games;
    if (this.#selected !== null && this.#selected >= agents(scene).length) this.#selected = null;
    const steps = this.game.length;
    const before = this.player.step;
    const ruled = old.rules !== scene.rules || (scene.others !== null && others < 2);
    this.player.length = steps;
    this.#aim();
    // Under other rules the last step is shown again: the same commands, another result.
    if (ruled && steps) this.player.jump(steps - 1);
    if ((ruled && steps) || Math.abs(steps - before) === 1) this.player.move(steps - this.player.step);
    else this.player.jump(steps);
    this.#emit();
  }

  #aim(): void {
    this.player.glide = SECONDS[this.#scene.rules.interaction];
  }

  #continue(): void {
    if (this.#running && this.player.arrived) this.step();
  }

  #emit(): void {
    this.dispatchEvent(new Event("change"));
  }
}
