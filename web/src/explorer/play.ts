// A match of a run, played by the engine in the page.

import type { Engine, Match } from "../engine/engine.ts";
import { policyOf } from "./data.ts";
import type { Run } from "./data.ts";
import type { Selection } from "./store.ts";

/** Play a match with the engine: the very one of the evaluation, unless another seed is chosen. */
export function playedMatch(engine: Engine, run: Run, { pursuer, evader, episode, seed }: Selection): Match {
  const own = run.seeds[pursuer]![evader]!;
  return engine.match(
    run.world, policyOf(run, "pursuer", pursuer), policyOf(run, "evader", evader), BigInt(seed ?? own), episode,
  );
}
