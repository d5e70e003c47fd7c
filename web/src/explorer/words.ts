// A step in words: captures, agents that disappear, and why agents bounced.

import { agentName } from "../page/names.ts";
import { disappeared, newlyCaptured } from "../board/recording.ts";
import type { Recording } from "../board/recording.ts";
import type { Conflict, WorldConfig } from "../engine/types.ts";

export interface Word {
  readonly kind: "capture" | "end" | "obstacle" | "teammate" | "adversary" | "start";
  readonly text: string;
  /** The agents that it speaks of. */
  readonly agents: readonly number[];
}

/** What is told: a match, or a recording of one. */
export interface Told {
  readonly config: WorldConfig;
  readonly length: number;
  readonly statistics: { readonly capture_rate: number };
  conflicts(step: number): readonly Conflict[];
}

/** Return what happened in a step, the most important first. */
export function wordsOf(match: Told, recording: Recording, step: number): Word[] {
  if (step === 0) return [{ kind: "start", text: startOf(match), agents: [] }];
  const before = recording.moments[step - 1]!;
  const after = recording.moments[step]!;
  const name = (agent: number): string => agentName(agent, match.config.n_pursuers);
  const captured = newlyCaptured(recording, before, after);
  const conflicts = match.conflicts(step);
  const explained = new Set(conflicts.flatMap((conflict) => conflict.doomed));
  const words: Word[] = captured.map((agent) => ({
    kind: "capture",
    text: `${name(agent)} is captured`,
    agents: [agent],
  }));
  for (const agent of disappeared(before, after)) {
    if (!captured.includes(agent) && !explained.has(agent)) {
      words.push({ kind: "end", text: `${name(agent)} disappears`, agents: [agent] });
    }
  }
  words.push(...conflicts.map(({ kind, text, agents }): Word => ({ kind, text, agents })));
  if (step === match.length) words.unshift({ kind: "end", text: endOf(match), agents: [] });
  return words;
}

function startOf({ config }: Told): string {
  return `${config.n_pursuers} pursuers and ${config.n_evaders} evaders on ${config.rows} x ${config.cols} cells, at most ${config.max_steps} steps`;
}

function endOf(match: Told): string {
  const captured = Math.round(match.statistics.capture_rate * match.config.n_evaders);
  return `The episode ends after ${match.length} steps with ${captured} of ${match.config.n_evaders} evaders captured`;
}
