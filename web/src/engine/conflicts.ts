/** Conflicts in words: the sentences of `matrixworld.world.conflicts`, from the same templates. */

import {
  AGENT_NAMES,
  CONFLICT_COLUMNS,
  CONFLICT_EVENTS,
  CONFLICT_OUTCOMES,
  CONFLICT_SENTENCE,
  FORMS,
  KINDS,
} from "./tables.ts";
import type { Conflict } from "./types.ts";

/** Numbers of a conflict: the step, then those that CONFLICT_COLUMNS names. */
export const CONFLICT_WIDTH = 1 + CONFLICT_COLUMNS.length;

function fill(template: string, values: Readonly<Record<string, string | number>>): string {
  return template.replace(/\{(\w+)\}/g, (_, name: string) => String(values[name]));
}

/** Return the name of an agent: pursuer_0 and so on, then evader_0 and so on. */
export function agentName(agent: number, n_pursuers: number): string {
  return agent < n_pursuers
    ? fill(AGENT_NAMES[0], { number: agent })
    : fill(AGENT_NAMES[1], { number: agent - n_pursuers });
}

/** Return a conflict from its numbers, which CONFLICT_COLUMNS names. */
export function conflictOf(numbers: ArrayLike<number>, n_pursuers: number): Conflict {
  const [turn, kind, form, first, second, row, col, ...bits] = Array.from(numbers) as [
    ...[number, number, number, number, number, number, number],
    ...number[],
  ];
  const agents = second < 0 ? [first] : [first, second];
  const [at_fault, held, doomed] = bits.map((bit) => agents.filter((_, side) => (bit >> side) & 1)) as [
    number[],
    number[],
    number[],
  ];
  const names = agents.map((agent) => agentName(agent, n_pursuers));
  const event = fill(CONFLICT_EVENTS[second < 0 ? "obstacle" : FORMS[form]!], {
    first: names[0]!,
    second: names[names.length - 1]!,
    cell: `(${row}, ${col})`,
  });
  const text = fill(CONFLICT_SENTENCE, {
    event,
    outcome: outcomeOf(agents.length, held, doomed, n_pursuers),
  });
  return {
    kind: KINDS[kind]!,
    form: FORMS[form]!,
    agents,
    cell: [row, col],
    at_fault,
    held,
    doomed,
    turn,
    text,
  };
}

function outcomeOf(sides: number, held: number[], doomed: number[], n_pursuers: number): string {
  if (sides === 2 && held.length === 2) return CONFLICT_OUTCOMES["both held"];
  if (sides === 2 && doomed.length === 2) return CONFLICT_OUTCOMES["both doomed"];
  const part = (how: "held" | "doomed") => (agent: number) =>
    fill(CONFLICT_OUTCOMES[how], { agent: agentName(agent, n_pursuers) });
  return [...held.map(part("held")), ...doomed.map(part("doomed"))].join(", ") || CONFLICT_OUTCOMES.none;
}

/** Return the conflicts of a table (n, 11), in its order. */
export function conflictsOf(table: Int32Array, n_pursuers: number): Conflict[] {
  const conflicts: Conflict[] = [];
  for (let at = 0; at < table.length; at += CONFLICT_WIDTH) {
    conflicts.push(conflictOf(table.subarray(at + 1, at + CONFLICT_WIDTH), n_pursuers));
  }
  return conflicts;
}
