// What a team of ratings does, in a sentence: by how far its inputs move ratings in matches of the page,
// which does not say what they are worth.

import type { Engine, Match } from "../engine/engine.ts";
import type { OfTeams, Team } from "../engine/teams.ts";
import type { GenomePolicy } from "../engine/types.ts";
import type { EvolveData } from "./data.ts";
import { mean } from "./measures.ts";

/**
 * Effects, in shares of the largest one, that a sentence tells, and that it tells as little; and
 * the most of them.
 */
const CLEAR = 1 / 3;
const SLIGHT = 1 / 10;
const MOST_CLEAR = 4;
const MOST_SLIGHT = 2;
/** Moments of a match that are looked at. */
const MOMENTS = 12;

const listed = (parts: readonly string[]): string =>
  parts.length > 1 ? `${parts.slice(0, -1).join(", ")} and ${parts.at(-1)}` : (parts[0] ?? "");

/** Return in a sentence what an agent does by the effects of its inputs: `explanation.sentence`. */
export function sentence(
  { phrases, words }: Pick<EvolveData, "phrases" | "words">,
  team: Team,
  effects: Readonly<Record<string, number>>,
): string {
  const sizes = Object.entries(effects)
    .map(([name, effect]) => [name, Math.abs(effect)] as const)
    .sort(([, a], [, b]) => b - a);
  const largest = sizes[0]?.[1] || Infinity;
  const clear = sizes
    .filter(([, size]) => size / largest >= CLEAR)
    .slice(0, MOST_CLEAR)
    .map(([name]) => phrases[name]![effects[name]! > 0 ? 1 : 0]);
  const little = sizes
    .filter(([, size]) => size / largest >= SLIGHT && size / largest < CLEAR)
    .slice(0, MOST_SLIGHT)
    .map(([name]) => phrases[name]![2]);
  const does =
    listed([...clear, ...(little.length ? [`minds ${listed(little)} little`] : [])]) ||
    "takes any move that is allowed";
  return `{A} ${team} ${does}.`.replaceAll(/\{(\w+)\}/g, (_, name: string) => words[team][name]!);
}

/**
 * Return the effect of each input of a team's weights: how far it moves the ratings of the moves in
 * a match.
 */
export function effectsOf(
  engine: Engine,
  match: Match,
  team: Team,
  policies: OfTeams<GenomePolicy>,
): Record<string, number> {
  const policy = policies[team];
  if (policy.kind !== "rating") return {};
  const { n_pursuers, n_evaders } = match.config;
  const agents = Array.from(
    { length: team === "pursuer" ? n_pursuers : n_evaders },
    (_, place) => place + (team === "pursuer" ? 0 : n_pursuers),
  );
  const world = engine.world(match.config);
  const variances = policy.inputs.map((): number[] => []);
  for (let step = 0; step < match.length; step += Math.max(1, Math.floor(match.length / MOMENTS))) {
    match.seek(world, step, { pursuers: policies.pursuer, evaders: policies.evader });
    for (const agent of agents.filter((each) => match.alive[step * match.n_agents + each])) {
      const { inputs, refused } = world.rate(policy, agent);
      inputs.forEach((moves, input) => {
        const allowed = Array.from(moves).filter((_, move) => !refused[move]);
        if (allowed.length) variances[input]!.push(mean(allowed.map((each) => (each - mean(allowed)) ** 2)));
      });
    }
  }
  world.free();
  return Object.fromEntries(
    policy.inputs.map((name, input) => [
      name,
      policy.genome[input]! * Math.sqrt(variances[input]!.length ? mean(variances[input]!) : 0),
    ]),
  );
}
