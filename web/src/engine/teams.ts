// The two teams, in the order that the engine has them.

export type Team = "pursuer" | "evader";
export const TEAMS = ["pursuer", "evader"] as const;
export const otherOf = (team: Team): Team => (team === "pursuer" ? "evader" : "pursuer");

/** A value for each team. */
export type OfTeams<Value> = Readonly<Record<Team, Value>>;
