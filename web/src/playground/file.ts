// A match as the file that `matrixworld.Episode` saves and loads.

import { EngineError } from "../engine/engine.ts";
import type { Engine } from "../engine/engine.ts";
import type { Cell, WorldArrays, WorldConfig } from "../engine/types.ts";
import { replayed } from "../board/live.ts";
import type { Live } from "../board/live.ts";
import { readNpz, writeNpz } from "../page/npz.ts";
import type { NpyArray } from "../page/npz.ts";

/** As in `matrixworld.episodes.episode`. */
const FORMAT = "matrixworld episode 3";

/** Return the bytes of the file of a match; `seat` is the agent that a person moved. */
export function episodeFile(engine: Engine, live: Live, seat: number): Uint8Array {
  const { config, actions, length, recording } = live;
  const agents = config.n_pursuers + config.n_evaders;
  const evaders = config.n_evaders;
  const moments = {
    positions: ["<i4", agents, 2],
    last_positions: ["<i4", agents, 2],
    alive: ["|b1", agents],
    captured: ["|b1", evaders],
    ever_captured: ["|b1", evaders],
  } as const;
  const steps = {
    rewards: ["<f4", agents],
    involved: ["|b1", agents, 3],
    fault: ["|b1", agents, 3],
  } as const;
  const kept: Record<string, number[][]> = {};
  const keep = (names: object): void => {
    for (const name of Object.keys(names)) {
      (kept[name] ??= []).push(Array.from(world.read(name as keyof WorldArrays), Number));
    }
  };
  const world = engine.world(config);
  world.reset(live.start);
  const conflicts: number[] = [];
  keep(moments);
  for (const each of actions) {
    world.step(each);
    keep({ ...moments, ...steps });
    conflicts.push(...world.conflictTable());
  }
  world.free();
  const types = { "<i4": Int32Array, "<f4": Float32Array, "|b1": Uint8Array } as const;
  const arrays: Record<string, NpyArray> = {};
  for (const [name, [dtype, ...shape]] of Object.entries({ ...moments, ...steps })) {
    const rows = length + Number(name in moments);
    arrays[name] = { dtype, shape: [rows, ...shape], data: types[dtype].from((kept[name] ?? []).flat()) };
  }
  // A small number of 64 bits is two of 32, the low one first.
  const single = (value: number): NpyArray => ({ dtype: "<i8", shape: [], data: Int32Array.of(value, 0) });
  const text = (value: string): NpyArray => ({ dtype: "<U", shape: [], data: value });
  return writeNpz({
    format: text(FORMAT),
    n_pursuers: single(config.n_pursuers),
    config: text(JSON.stringify(config)),
    seat: single(seat),
    ...arrays,
    actions: {
      dtype: "|i1",
      shape: [length, agents],
      data: Int8Array.from(actions.flatMap((each) => [...each])),
    },
    map: {
      dtype: "|b1",
      shape: [config.rows, config.cols],
      data: Uint8Array.from(recording.obstacles, Number),
    },
    conflict_table: { dtype: "<i4", shape: [conflicts.length / 11, 11], data: Int32Array.from(conflicts) },
  });
}

/**
 * Play the match of a file again: the same start, the same actions; `seat` is that of the person.
 * Throws an error with what is wrong.
 */
export function readEpisode(engine: Engine, bytes: Uint8Array): { live: Live; seat: number | null } {
  const arrays = readNpz(bytes);
  const numbers = (name: string): number[] => Array.from((arrays[name]?.data ?? []) as ArrayLike<number>);
  if (arrays["format"]?.data !== FORMAT) throw new EngineError(`expected a file marked "${FORMAT}"`);
  const config = JSON.parse(arrays["config"]!.data as string) as WorldConfig;
  const agents = config.n_pursuers + config.n_evaders;
  const positions = numbers("positions");
  const cells = (first: number, last: number): Cell[] =>
    Array.from({ length: last - first }, (_, place): Cell => [
      positions[2 * (first + place)]!,
      positions[2 * (first + place) + 1]!,
    ]);
  const start = {
    pursuers: cells(0, config.n_pursuers),
    evaders: cells(config.n_pursuers, agents),
    obstacles: Uint8Array.from(numbers("map")),
  };
  const all = Uint8Array.from(numbers("actions"));
  const actions = Array.from({ length: all.length / agents }, (_, step) =>
    all.subarray(step * agents, (step + 1) * agents),
  );
  const live = replayed(engine, config, start, actions);
  const last = Array.from(live.recording.moments.at(-1)!.positions);
  if (
    last.join() !==
    numbers("last_positions")
      .slice(-2 * agents)
      .join()
  ) {
    throw new EngineError("expected the moves of this start to lead to its end");
  }
  return { live, seat: numbers("seat")[0] ?? null };
}
