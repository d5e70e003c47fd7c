// Names of agents, actions and generations, as in the Python package.

export { agentName } from "../engine/conflicts.ts";

/** Return the name of a generation: a number alone would read as a count of agents. */
export const generationName = (team: "pursuer" | "evader", number: number): string => `${team}s of generation ${number}`;

export const ACTIONS = ["stay", "north", "east", "south", "west", "northeast", "southeast", "southwest", "northwest"] as const;
