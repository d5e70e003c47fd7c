// Names of agents and actions, as in the Python package.

export const agentName = (agent: number, nPursuers: number): string =>
  agent < nPursuers ? `pursuer_${agent}` : `evader_${agent - nPursuers}`;

export const ACTIONS = ["stay", "north", "east", "south", "west", "northeast", "southeast", "southwest", "northwest"] as const;
