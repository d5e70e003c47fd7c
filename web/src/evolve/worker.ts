// The race in a thread of its own: the page stays as quick as without one. Messages go in both directions.

import { loadEngine } from "../engine/engine.ts";
import { text } from "../explorer/data.ts";
import type { Mask } from "./network.ts";
import { Race } from "./race.ts";
import type { OfTeams, RaceEvent } from "./race.ts";
import type { Finished } from "./save.ts";
import type { RaceSettings } from "./settings.ts";

/** What the page asks for. A start ends a race that goes on. */
export type Order =
  | { readonly type: "start"; readonly settings: RaceSettings; readonly masks: OfTeams<Mask> }
  | { readonly type: "change"; readonly settings: RaceSettings }
  | { readonly type: "stop" }
  | { readonly type: "save" };

/** What the worker tells: the race's events, its end, and what can be saved. */
export type Told =
  | RaceEvent
  | { readonly type: "end"; readonly seconds: number }
  | { readonly type: "saved"; readonly race: Finished }
  | { readonly type: "failed"; readonly message: string };

/** Milliseconds after which orders are looked for. */
const SLICE = 12;

/** Return a thread that runs the scripts of a page as a worker. */
export function startWorker(page: string): Worker {
  const script = new Blob([text("script-engine"), "\n", text(`script-${page}`)], { type: "text/javascript" });
  return new Worker(URL.createObjectURL(script));
}

/** Carry out orders, in the global scope of a worker. */
export function work(): void {
  const tell = (told: Told): void => postMessage(told);
  const engine = loadEngine();
  let race: Race | null = null;
  let steps: Generator<RaceEvent, void> | null = null;
  let began = 0;
  let due = false;
  const turns = new MessageChannel();

  const play = (): void => {
    const until = performance.now() + SLICE;
    while (steps && performance.now() < until) {
      const { value, done } = steps.next();
      if (!done) tell(value);
      else {
        steps = null;
        tell({ type: "end", seconds: (performance.now() - began) / 1000 });
      }
    }
    if (!steps || due) return;
    due = true;
    turns.port2.postMessage(null); // after the orders that have come meanwhile
  };

  const obey = async (order: Order): Promise<void> => {
    if (order.type === "start") {
      race = new Race(await engine, order.settings, order.masks);
      [steps, began] = [race.run(), performance.now()];
      play();
    } else if (order.type === "stop") {
      steps = null;
    } else if (order.type === "change") {
      const event = race?.change(order.settings);
      if (event) tell(event);
      if (!race || !event || steps) return;
      steps = race.catchUp(); // the race has ended: its generations play in the new world
      play();
    } else if (race) {
      const { settings, archive, rows, cells, counters, finished } = race;
      tell({ type: "saved", race: { settings, archive, rows, cells, counters, finished } });
    }
  };

  const guarded = (act: () => unknown): void => {
    Promise.resolve().then(act).catch((error: unknown) => {
      steps = null;
      tell({ type: "failed", message: String(error) });
    });
  };
  turns.port1.onmessage = () => {
    due = false;
    guarded(play);
  };
  globalThis.onmessage = ({ data }: MessageEvent<Order>) => guarded(() => obey(data));
}
