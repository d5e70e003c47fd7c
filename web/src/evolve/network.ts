// The policies of a race and their genomes: of networks layer by layer the weights (inputs,
// outputs), then the biases.

import type { Activation, GenomePolicy, RatingPolicy } from "../engine/types.ts";
import type { Draws } from "./draws.ts";
import type { RaceSettings } from "./settings.ts";

/**
 * Moves that a team's mask forbids: for each move the places (channel, down, right) of a view that
 * forbid it.
 */
export type Mask = readonly (readonly (readonly [channel: number, down: number, right: number])[])[];

/** What a network over cells looks like; the mask has units of its own. */
interface Cells {
  readonly kind: "cells";
  readonly fov: number;
  readonly hidden: readonly number[];
  readonly mask: Mask | null;
}

/** A network, or what rates moves by a weighted sum of named inputs. */
export type Shape = Cells | Omit<RatingPolicy, "genome">;

/** Stay and four moves: the page has no worlds in which agents move diagonally. */
const ACTIONS = 5;
const MOVES = ACTIONS - 1;
const CHANNELS = 3;
/** Added to the output of a forbidden move, as in `matrixworld.coevolution.learners.masked_network`. */
const FORBIDDEN = -(2 ** 100);

/** One layer of a genome: where it begins, and its size. */
type Layer = Readonly<Record<"at" | "inputs" | "outputs", number>>;

/** The hidden layers, with the units of the mask. */
const hiddenOf = ({ hidden, mask }: Cells): number[] => hidden.map((size) => size + (mask ? MOVES : 0));

function layersOf(shape: Cells): Layer[] {
  const sizes = [CHANNELS * shape.fov ** 2, ...hiddenOf(shape), ACTIONS];
  let at = 0;
  return sizes.slice(1).map((outputs, number) => {
    const layer = { at, inputs: sizes[number]!, outputs };
    at += (layer.inputs + 1) * outputs;
    return layer;
  });
}

export function genesOf(shape: Shape): number {
  if (shape.kind === "rating") return shape.inputs.length;
  const { at, inputs, outputs } = layersOf(shape).at(-1)!;
  return at + (inputs + 1) * outputs;
}

/** Return genomes, one after the other, as what plays for a team. */
export const policyOf = (shape: Shape, genome: Float32Array): GenomePolicy =>
  shape.kind === "rating"
    ? { ...shape, genome }
    : {
        kind: "cells",
        hidden: hiddenOf(shape),
        activation: "relu" satisfies Activation,
        sampled: true,
        memory: "none",
        genome,
      };

/** Return a random genome: normal numbers, whose standard deviations the settings have. */
export function untrained(shape: Shape, draws: Draws, policy: RaceSettings["policy"]): Float32Array {
  const weight = policy.initial_weight;
  if (shape.kind === "rating" || policy.kind === "rating") {
    return draws.normals(genesOf(shape)).map((normal) => Math.fround(weight) * normal);
  }
  const head = policy.initial_head;
  const genome = new Float32Array(genesOf(shape));
  const layers = layersOf(shape);
  layers.forEach(({ at, inputs, outputs }, number) => {
    const scale = Math.fround(number === layers.length - 1 ? head : weight);
    draws.normals(inputs * outputs).forEach((normal, i) => (genome[at + i] = scale * normal));
  });
  return genome;
}

/** Genes that no learner changes: flags, and their values. */
export interface FixedGenes {
  readonly fixed: Uint8Array;
  readonly values: Float32Array;
}

/** Return the genes of the mask: a unit for each move that is active if the move is forbidden. */
export function fixedOf(shape: Shape): FixedGenes | null {
  if (shape.kind === "rating") return null;
  const { fov, mask } = shape;
  if (!mask) return null;
  const fixed = new Uint8Array(genesOf(shape));
  const values = new Float32Array(genesOf(shape));
  const layers = layersOf(shape);
  const last = layers.length - 1;
  const middle = Math.floor(fov / 2);
  layers.forEach(({ at, inputs, outputs }, number) => {
    const place = (input: number, output: number): number => at + input * outputs + output;
    // A unit of the mask hears of nothing else, and nothing else hears of it.
    for (let unit = 0; unit < MOVES; unit++) {
      if (number > 0) fixed.fill(1, place(inputs - MOVES + unit, 0), place(inputs - MOVES + unit + 1, 0));
      if (number < last) {
        for (let input = 0; input <= inputs; input++) fixed[place(input, outputs - MOVES + unit)] = 1;
      }
    }
    mask.forEach((cells, move) => {
      const target = number === last ? 1 + move : outputs - MOVES + move;
      const sources =
        number === 0
          ? cells.map(([channel, down, right]) => (channel * fov + middle + down) * fov + middle + right)
          : [inputs - MOVES + move];
      for (const source of sources) {
        fixed[place(source, target)] = 1;
        values[place(source, target)] = number === last ? FORBIDDEN : 1;
      }
    });
  });
  return { fixed, values };
}

/** Write the genes of the mask into a genome, and return it. */
export function masked(genome: Float32Array, genes: FixedGenes | null): Float32Array {
  return genes ? genome.map((gene, i) => (genes.fixed[i] ? genes.values[i]! : gene)) : genome;
}

/**
 * Return a genome for a network with another view or mask. What it has learned stays; it knows nothing yet of
 * cells that it did not see before.
 */
export function reshaped(genome: Float32Array, from: Shape, to: Shape): Float32Array {
  if (from.kind === "rating" || to.kind === "rating") return genome; // their inputs are the same in any view
  const made = new Float32Array(genesOf(to));
  const before = layersOf(from);
  const after = layersOf(to);
  const moved = Math.floor(to.fov / 2) - Math.floor(from.fov / 2);
  const inView = (cell: number): boolean => cell >= 0 && cell < to.fov;
  /** Where an input of the first layer is in the other view; -1 outside of it. */
  const seen = (input: number): number => {
    const channel = Math.floor(input / from.fov ** 2);
    const row = (Math.floor(input / from.fov) % from.fov) + moved;
    const col = (input % from.fov) + moved;
    return inView(row) && inView(col) ? (channel * to.fov + row) * to.fov + col : -1;
  };
  before.forEach((old, number) => {
    const layer = after[number]!;
    const outputs = from.hidden[number] ?? ACTIONS; // without units of a mask
    for (let input = 0; input < (number ? from.hidden[number - 1]! : old.inputs); input++) {
      const place = number ? input : seen(input);
      if (place < 0) continue;
      for (let out = 0; out < outputs; out++) {
        made[layer.at + place * layer.outputs + out] = genome[old.at + input * old.outputs + out]!;
      }
    }
    for (let out = 0; out < outputs; out++) {
      made[layer.at + layer.inputs * layer.outputs + out] = genome[old.at + old.inputs * old.outputs + out]!;
    }
  });
  // Without hidden layers, weights of a mask lie among the others: they are forgotten, not learned.
  return masked(
    made.map((gene) => (gene <= FORBIDDEN / 2 ? 0 : gene)),
    fixedOf(to),
  );
}
