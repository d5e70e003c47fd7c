// Written by web/write_tables.py from the Python package; do not edit.

/** The numbers that the engine has for the names of enumerations. */
export const INTERACTIONS = {"SIMULTANEOUS": 0, "SWARM_TURNS": 1, "AGENT_TURNS": 2} as const;
export const OUTCOMES = {"DISAPPEAR": 0, "REACH": 1, "BOUNCE": 2} as const;
export const CAPTURES = {"OCCUPATION": 0, "SURROUND": 1} as const;
export const BLAMES = {"FAULT": 0, "INVOLVED": 1} as const;

/** The actions by their numbers; the last four are diagonal. */
export const ACTIONS = [
  "STAY",
  "NORTH",
  "EAST",
  "SOUTH",
  "WEST",
  "NORTHEAST",
  "SOUTHEAST",
  "SOUTHWEST",
  "NORTHWEST"
] as const;

/** The texts of conflicts: templates that Python fills, too. */
export const KINDS = ["obstacle", "teammate", "adversary"] as const;
export const FORMS = ["vertex", "edge", "chain"] as const;
export const CONFLICT_COLUMNS = [
  "turn",
  "kind",
  "form",
  "first",
  "second",
  "row",
  "col",
  "at_fault",
  "held",
  "doomed"
] as const;
export const AGENT_NAMES = ["pursuer_{number}", "evader_{number}"] as const;
export const CONFLICT_EVENTS = {
  "obstacle": "{first} ran into the obstacle or border at {cell}",
  "vertex": "{first} and {second} both headed for {cell}",
  "edge": "{first} and {second} meant to swap, {first} to {cell}",
  "chain": "{first} headed for {cell}, where {second} had to stay"
} as const;
export const CONFLICT_OUTCOMES = {
  "both held": "both bounce",
  "both doomed": "both disappear",
  "held": "{agent} bounces",
  "doomed": "{agent} disappears",
  "none": "nobody is stopped"
} as const;
export const CONFLICT_SENTENCE = "{event}: {outcome}" as const;

/** What each script does. */
export const SCRIPTS = {
  "random": "any action, all equally likely",
  "still": "always stays",
  "chaser": "moves to where the nearest adversary in view is nearest",
  "fleer": "moves to where the nearest adversary in view is farthest",
  "clumsy-chaser": "a chaser that takes any action in half of the steps",
  "hunter": "a chaser of the nearest adversary in view to which no teammate in view is nearer",
  "surrounder": "a chaser of the nearest free cell beside an adversary without a teammate",
  "clumsy-fleer": "a fleer that takes any action in half of the steps",
  "dodger": "moves to where all adversaries in view together are farthest",
  "team-surrounder": "shares the free cells beside adversaries with its teammates, and searches",
  "careful-random": "as random, but takes only moves that right of way allows",
  "careful-chaser": "as chaser, but takes only moves that right of way allows",
  "careful-fleer": "as fleer, but takes only moves that right of way allows",
  "careful-clumsy-chaser": "as clumsy-chaser, but takes only moves that right of way allows",
  "careful-hunter": "as hunter, but takes only moves that right of way allows",
  "careful-surrounder": "as surrounder, but takes only moves that right of way allows",
  "careful-clumsy-fleer": "as clumsy-fleer, but takes only moves that right of way allows",
  "careful-dodger": "as dodger, but takes only moves that right of way allows",
  "careful-team-surrounder": "as team-surrounder, but takes only moves that right of way allows"
} as const;

/** The named inputs of a move, in the order of the engine, and what they are. */
export const INPUTS = {
  "adversary": "distance to the nearest adversary (0 to 2, in half views)",
  "pressure": "sum over adversaries of 1 / (1 + moves)^2 (0 or more)",
  "unclaimed": "distance to the nearest adversary to which no teammate is nearer than the agent is now; without one, to the nearest adversary (0 to 2, in half views)",
  "open_side": "distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 to 2, in half views)",
  "teammate": "distance to the nearest teammate (0 to 2, in half views)",
  "exits": "share of the cells around that are no obstacle (0 to 1)",
  "room": "distance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",
  "must_yield": "1 if right of way forbids the move (0 to 1)",
  "ahead": "1 if it is the direction that the agent draws for each 12 steps (0 to 1)",
  "search": "1 if it leads on along the way on which an agent of team-surrounder searches the grid (0 to 1)",
  "escapes": "share of the cells that an evader may be on after its next move which hold no obstacle and which no pursuer in view reaches in one move: of the nearest adversary, or an evader's own (0 to 1)",
  "opposite": "(1 - cosine) / 2 of the angle at the nearest adversary between the agent and the teammate nearest to it; for an evader, of the angle at itself between its two nearest adversaries (0 to 1)",
  "parity": "1 if the distance to the nearest adversary is odd (0 to 1)"
} as const;

/** Characters of passable and of impassable cells in a map. */
export const MAP_CHARACTERS = {"free": ".GS", "blocked": "#@OTW"} as const;
