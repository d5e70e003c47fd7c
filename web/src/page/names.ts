// Names of agents and actions, as in the Python package.

export { agentName } from "../engine/conflicts.ts";

export const ACTIONS = [
  "stay",
  "north",
  "east",
  "south",
  "west",
  "northeast",
  "southeast",
  "southwest",
  "northwest",
] as const;
