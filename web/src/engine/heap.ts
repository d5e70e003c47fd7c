/**
 * Named arrays in the engine's memory: what web/engine/named_arrays.hpp declares in C++.
 */

import { EngineError } from "./errors.ts";

/** The functions and the memory of the compiled engine; web/engine/engine.cpp says what they do. */
export interface Compiled {
  readonly HEAPU8: Uint8Array;
  _malloc(size: number): number;
  _free(at: number): void;
  _last_outputs(): number;
  _last_error(): number;
  _world_new(config: number): number;
  _world_free(world: number): void;
  _world_reset(world: number, start: number): number;
  _world_step(world: number, actions: number): number;
  _world_play_turn(world: number, actions: number): number;
  _world_turn(world: number): number;
  _world_read(world: number, name: number): number;
  _world_conflicts(world: number): number;
  _world_decide(world: number, policy: number, first: number, last: number, actions: number): number;
  _world_logits(world: number, policy: number, agent: number): number;
  _world_rate(world: number, policy: number, agent: number): number;
  _world_snapshot(world: number): number;
  _world_restore(world: number, snapshot: number): number;
  _states_new(config: number): number;
  _states_free(states: number): void;
  _states_payoffs(states: number): number;
  _states_backup(states: number, turn: number, given: number): number;
  _states_weigh(states: number, turn: number, evaders: number, step: number, policy: number): number;
  _states_game(states: number, world: number, next: number): number;
  _play_match(config: number, pursuers: number, evaders: number, episode: number): number;
  _play_rollout(config: number, pursuers: number, evaders: number, matches: number): number;
}

/** Arrays that cross. */
export type NumberArray =
  Uint8Array | Int32Array | BigInt64Array | BigUint64Array | Float32Array | Float64Array;

/** Flags, bytes of 0 and 1: a type of its own in C++. */
export class Flags {
  readonly bytes: Uint8Array;
  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
  }
}

export type Inputs = Record<string, NumberArray | Flags>;
export type Outputs = Record<string, NumberArray>;

// The numbers of the engine's DType.
const BOOL = 0;
const NUMBERS = [
  Uint8Array,
  Uint8Array,
  Int32Array,
  BigInt64Array,
  BigUint64Array,
  Float32Array,
  Float64Array,
];
const WORD = 4; // bytes
const RECORD = 4; // words: name, dtype, n, data

const encoder = new TextEncoder();
const decoder = new TextDecoder();

function dtypeOf(array: NumberArray): number {
  // From the end: bytes are UInt8, unless they are marked as flags.
  for (let dtype = NUMBERS.length - 1; dtype > BOOL; --dtype) {
    if (array instanceof NUMBERS[dtype]!) return dtype;
  }
  throw new TypeError("array: expected a typed array of the engine's numbers, got another");
}

function bytesOf(array: NumberArray): Uint8Array {
  return new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
}

/** Return a text as bytes that end with 0, as C++ reads a name. */
function named(text: string): Uint8Array {
  return encoder.encode(`${text}\0`);
}

/** Arguments in the engine's memory, which live as long as one call. */
export class Block {
  private readonly engine: Compiled;
  private readonly addresses: number[] = [];

  constructor(engine: Compiled) {
    this.engine = engine;
  }

  private copy(bytes: Uint8Array): number {
    const at = this.engine._malloc(Math.max(bytes.length, 1));
    if (at === 0) throw new EngineError("memory: expected room for the arguments, got none");
    this.addresses.push(at);
    this.engine.HEAPU8.set(bytes, at); // `HEAPU8` is another view after the memory has grown
    return at;
  }

  /** Return the address of a text. */
  text(text: string): number {
    return this.copy(named(text));
  }

  /** Return the address of named arrays. */
  arrays(inputs: Inputs): number {
    const entries = Object.entries(inputs);
    const words = entries.flatMap(([name, given]) => {
      const flags = given instanceof Flags;
      const array = flags ? given.bytes : given;
      return [this.text(name), flags ? BOOL : dtypeOf(array), array.length, this.copy(bytesOf(array))];
    });
    const records = this.copy(bytesOf(Int32Array.from(words)));
    return this.copy(bytesOf(Int32Array.of(entries.length, records)));
  }

  free(): void {
    for (const address of this.addresses) this.engine._free(address);
  }
}

/** Return the text at an address. */
export function textAt(engine: Compiled, at: number): string {
  const heap = engine.HEAPU8;
  return decoder.decode(heap.subarray(at, heap.indexOf(0, at)));
}

/** Return copies of the results of the last call, by name. */
export function lastOutputs(engine: Compiled): Outputs {
  const words = new Int32Array(engine.HEAPU8.buffer);
  const head = engine._last_outputs() / WORD;
  const first = words[head + 1]! / WORD;
  const outputs: Outputs = {};
  for (let record = first; record < first + words[head]! * RECORD; record += RECORD) {
    const Kind = NUMBERS[words[record + 1]!]!;
    const length = words[record + 2]! * Kind.BYTES_PER_ELEMENT;
    const data = words[record + 3]!;
    outputs[textAt(engine, words[record]!)] = new Kind(engine.HEAPU8.slice(data, data + length).buffer);
  }
  return outputs;
}

/**
 * Call a function of the engine with arguments in its memory, and free them.
 * Throws EngineError with the engine's message if the function returns 0.
 */
export function call(engine: Compiled, invoke: (block: Block) => number): number {
  const block = new Block(engine);
  try {
    const result = invoke(block);
    if (result === 0) throw new EngineError(textAt(engine, engine._last_error()));
    return result;
  } finally {
    block.free();
  }
}
