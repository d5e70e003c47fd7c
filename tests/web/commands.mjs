// Carry out commands in the built engine: a line of JSON for each, and one for its answer.

import { createInterface } from "node:readline";

import { conflicts, engine, output, policyOf, rollout, whyNotSolved } from "./engine.mjs";

const { opposition, shownInputs } = await import(
  new URL("../../web/src/explorer/shown_inputs.ts", import.meta.url)
);

const ARRAYS = [
  ...["positions", "last_positions", "alive", "captured", "ever_captured"],
  ...["actions", "rewards", "involved", "fault", "map"],
];

function startOf(start) {
  return start.seed === undefined ? start : { ...start, seed: BigInt(start.seed) };
}

/** Return what `World` tells after a step or a reset. */
function told(world, names) {
  const arrays = Object.fromEntries(names.map((name) => [name, world.read(name)]));
  return { ...arrays, conflicts: world.conflicts(), turn: world.turn, over: world.over };
}

const COMMANDS = {
  match({ config, pursuers, evaders, seed, episode, seek }) {
    const match = engine.match(config, policyOf(pursuers), policyOf(evaders), BigInt(seed), episode);
    const steps = Array.from({ length: match.length + 1 }, (_, step) => match.conflicts(step));
    const arrays = Object.fromEntries(ARRAYS.map((name) => [name, match[name]]));
    const world = engine.world(config);
    const policies = { pursuers: policyOf(pursuers), evaders: policyOf(evaders) };
    const sought = seek.map((step) => {
      match.seek(world, step, policies);
      return world.read("positions");
    });
    return { ...arrays, length: match.length, conflicts: steps, statistics: match.statistics, sought };
  },
  rollout({ config, pursuers, evaders, seed, episodes }) {
    return rollout(config, policyOf(pursuers), policyOf(evaders), BigInt(seed), episodes);
  },
  play({ config, start, actions, turns, read }) {
    const world = engine.world(config);
    world.reset(startOf(start));
    const moments = [told(world, read)];
    for (const row of actions) {
      if (turns) world.playTurn(row);
      else world.step(row);
      moments.push(told(world, read));
    }
    return { moments, map: world.map() };
  },
  // What a board draws of all moves of agents, by agent and move.
  shown({ config, start, actions, agents, inputs }) {
    const world = engine.world(config);
    world.reset(startOf(start));
    for (const row of actions) world.step(row);
    const positions = world.read("positions");
    return agents.map((agent) =>
      Array.from({ length: config.diagonal ? 9 : 5 }, (_, move) => {
        const team = agent < config.n_pursuers ? "pursuer" : "evader";
        const at = [positions[2 * agent], positions[2 * agent + 1]];
        const shown = shownInputs({ config, view: world.view(agent), team, at, move }, inputs);
        return { ...shown, opposition: shown.sides && opposition(...shown.sides) };
      }),
    );
  },
  // Plays on from a snapshot in another world, after a detour in the first.
  resume({ config, start, before, after, edit, read }) {
    const world = engine.world(config);
    world.reset(startOf(start));
    for (const row of before) world.playTurn(row);
    const snapshot = world.snapshot();
    for (const [name, index, value] of edit) snapshot[name][index] = value;
    const other = engine.world(config);
    for (const each of [world, other]) {
      each.restore(snapshot);
      for (const row of after) each.playTurn(row);
    }
    return [told(world, read), told(other, read)];
  },
  // What policies answer at a moment: actions of a team, and a network's numbers for each agent.
  decide({ config, start, actions, policy, team, agents }) {
    const world = engine.world(config);
    world.reset(startOf(start));
    const player = policyOf(policy);
    for (const row of actions) world.replay(row, { pursuer: player, evader: player });
    const chosen = world.decide(player, team, new Uint8Array(world.n_agents).fill(9));
    return {
      chosen,
      answers: agents.map((agent) => world.answer(player, agent)),
      view: world.view(agents[0] ?? 0),
    };
  },
  // How a policy rates the moves of agents.
  rate({ config, start, actions, policy, agents }) {
    const world = engine.world(config);
    world.reset(startOf(start));
    for (const row of actions) world.step(row);
    return agents.map((agent) => world.rate(policyOf(policy), agent));
  },
  refuse({ config }) {
    engine.world(config);
  },
  // Perfect play at each moment of an episode, turn by turn, and what the teams lose by the actions.
  solve({ config, start, actions, payoff }) {
    const why = whyNotSolved(config);
    if (why) return { why };
    const solution = engine.solution(config, payoff);
    while (solution.goBack()) continue;
    const world = engine.world(config);
    world.reset(startOf(start));
    return actions.map((row) => {
      const game = solution.game(world);
      const told = game && {
        value: game.value,
        play: game.teams.map((team) => team.play),
        lost: game.lost(row),
        marginals: row.map((_, agent) => game.marginal(agent)),
      };
      world.playTurn(row);
      return told;
    });
  },
  texts({ table, n_pursuers }) {
    return conflicts.conflictsOf(Int32Array.from(table), n_pursuers);
  },
};

/** Return the answer to a command; an error becomes its message. */
function answer(command) {
  try {
    return COMMANDS[command.do](command);
  } catch (error) {
    return { error: error.message, kind: error.name };
  }
}

for await (const line of createInterface({ input: process.stdin })) {
  output(answer(JSON.parse(line)));
  process.stdout.write("\n");
}
