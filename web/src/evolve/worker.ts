// The race in a thread of its own: the page stays as quick as without one. Messages go in both directions.

import { loadEngine } from "../engine/engine.ts";
import type { OfTeams } from "../engine/teams.ts";
import { text } from "../explorer/data.ts";
import type { Mask } from "./network.ts";
import { Race } from "./race.ts";
import type { RaceEvent } from "./race.ts";
import type { Finished } from "./save.ts";
import type { RaceSettings } from "./settings.ts";

/** Other settings, after so many epochs. */
export interface Planned {
  readonly at: number;
  readonly settings: RaceSettings;
}

/**
 * What the page asks for. A start ends a race that goes on, and plays again what is planned until
 * so many epochs.
 */
export type Order =
  | {
      readonly type: "start";
      readonly settings: RaceSettings;
      readonly masks: OfTeams<Mask>;
      readonly plan: readonly Planned[];
      readonly until: number;
    }
  | { readonly type: "change"; readonly settings: RaceSettings }
  | { readonly type: "stop" | "go" | "save" };

/**
 * What the worker tells: the race's events, after how many epochs it changed or rests, its end, and
 * what can be saved.
 */
export type Told =
  | RaceEvent
  | { readonly type: "ready" | "began" }
  | { readonly type: "changed"; readonly at: number; readonly settings: RaceSettings }
  | { readonly type: "stopped"; readonly at: number }
  | { readonly type: "end"; readonly at: number; readonly seconds: number }
  | { readonly type: "saved"; readonly race: Finished }
  | { readonly type: "failed"; readonly message: string };

/** What both ends of the messages are. */
interface End<Sent, Heard> {
  postMessage(sent: Sent): void;
  onmessage: ((event: MessageEvent<Heard>) => unknown) | null;
}

/** Milliseconds after which orders are looked for. */
const SLICE = 12;

/**
 * Whoever carries out orders: a worker that runs the scripts of the page, or the page itself where
 * it may have none.
 */
export class Mate {
  #end: End<Order, Told> | null = null;
  #worker: Worker | null = null;
  #waiting: Order[] = [];
  readonly #hear: (told: Told) => void;

  constructor(page: string, hear: (told: Told) => void) {
    this.#hear = hear;
    try {
      const script = new Blob([text("script-engine"), "\n", text(`script-${page}`)], {
        type: "text/javascript",
      });
      this.#worker = new Worker(URL.createObjectURL(script));
      this.#worker.onerror = () => this.#end || this.#here(); // a policy of the page's place forbids it
      this.#worker.onmessage = () => this.#begin(this.#worker!);
    } catch {
      this.#here();
    }
  }

  send(order: Order): void {
    if (this.#end) this.#end.postMessage(order);
    else this.#waiting.push(order);
  }

  close(): void {
    this.send({ type: "stop" });
    this.#worker?.terminate();
  }

  #here(): void {
    const { port1, port2 } = new MessageChannel();
    work(port2);
    this.#begin(port1);
  }

  #begin(end: End<Order, Told>): void {
    this.#end = end;
    end.onmessage = ({ data }) => data.type !== "ready" && this.#hear(data);
    for (const order of this.#waiting.splice(0)) end.postMessage(order);
  }
}

/** Carry out the orders that come to an end of messages: in a worker its global scope. */
export function work(end: End<Told, Order>): void {
  const tell = (told: Told): void => end.postMessage(told);
  const engine = loadEngine();
  let race: Race | null = null;
  let steps: Generator<RaceEvent, void> | null = null;
  /** What is played while the race rests: the matches of its generations that are missing. */
  let missing: Generator<RaceEvent, void> | null = null;
  let plan: Planned[] = [];
  let going = false;
  let milliseconds = 0;
  let due = false;
  const turns = new MessageChannel();

  const change = (settings: RaceSettings): void => {
    const event = race!.change(settings);
    tell({ type: "changed", at: race!.epochs, settings });
    if (event) tell(event);
    if (!steps && race!.finished <= settings.schedule.generations) {
      steps = race!.run();
      going = true;
    } else if (!going) {
      missing = race!.catchUp();
    }
  };

  const rest = (): void => {
    going = false;
    missing = race!.catchUp();
    tell({ type: "stopped", at: race!.epochs });
  };

  /** Play one step; return whether there was one. */
  const step = (): boolean => {
    if (going && steps) {
      while (plan.length && plan[0]!.at <= race!.epochs) change(plan.shift()!.settings);
      const { value, done } = steps.next();
      if (done) {
        steps = null;
        going = false;
        missing = race!.catchUp(); // a late change has left some matches
        tell({ type: "end", at: race!.epochs, seconds: milliseconds / 1000 });
      } else if (value.type === "rest") {
        rest();
      } else {
        tell(value);
      }
      return true;
    }
    const found = missing?.next();
    if (found && !found.done) tell(found.value);
    else missing = null;
    return Boolean(missing);
  };

  const play = (): void => {
    const began = performance.now();
    let more = true;
    while (more && performance.now() < began + SLICE) more = step();
    milliseconds += performance.now() - began;
    if (!more || due) return;
    due = true;
    turns.port2.postMessage(null); // after the orders that have come meanwhile
  };

  const obey = async (order: Order): Promise<void> => {
    if (order.type === "start") {
      race = new Race(await engine, order.settings, order.masks);
      steps = race.run();
      missing = null;
      plan = [...order.plan];
      going = true;
      milliseconds = 0;
      race.until = order.until;
      tell({ type: "began" });
    } else if (!race) {
      return;
    } else if (order.type === "change") {
      plan = []; // from here on it is another race
      race.until = Infinity;
      change(order.settings);
    } else if (order.type === "go") {
      race.until = Infinity;
      going = true;
    } else if (order.type === "stop") {
      if (going) rest();
    } else {
      const { settings, archive, rows, cells, counters, finished } = race;
      tell({ type: "saved", race: { settings, archive, rows, cells, counters, finished } });
    }
    play();
  };

  const guarded = (act: () => unknown): void => {
    Promise.resolve()
      .then(act)
      .catch((error: unknown) => {
        steps = missing = null;
        tell({ type: "failed", message: String(error) });
      });
  };
  turns.port1.onmessage = () => {
    due = false;
    guarded(play);
  };
  end.onmessage = ({ data }) => guarded(() => obey(data));
  tell({ type: "ready" });
}
