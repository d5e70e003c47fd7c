// What Python tells the page: the variants, the fields of rules with their values, the scripts, the
// rewards and the gallery. The page adds nothing to it, so that page and package cannot diverge.

import type { OfTeams } from "../engine/teams.ts";
import type { PolicyShape, Rewards, Rules, ScriptName, TeamPolicy, WorldConfig } from "../engine/types.ts";
import { html } from "../page/dom.ts";

export interface Field {
  readonly name: keyof Rules;
  readonly label: string;
  readonly text: string;
  readonly values: readonly { readonly name: string; readonly label: string }[];
}

export interface Example {
  readonly title: string;
  /** What to predict. */
  readonly ask: string;
  /** What happens, and what to try. */
  readonly text: string;
  /** A scene as it stands in a link. */
  readonly scene: string;
  readonly champions?: Champions;
}

/** What played for a team in the match of the explorer that a scene comes from. */
export type Champions = OfTeams<{ readonly name: string; readonly policy: TeamPolicy }>;

export interface PageData {
  readonly variants: Readonly<Record<string, Rules>>;
  readonly titles: Readonly<Record<string, string>>;
  readonly fields: readonly Field[];
  readonly rewards: Readonly<Record<string, Rewards>>;
  readonly scripts: readonly { readonly name: ScriptName; readonly text: string }[];
  readonly gallery: readonly Example[];
  /** The scene to begin with where the address names none. */
  readonly scene: string;
  readonly champions?: Champions;
}

/** What can play for a team. */
export interface TeamData {
  readonly names: readonly string[];
  /** Of each name what it does. */
  readonly texts: readonly string[];
  /** The place of the one that a match begins with. */
  readonly usual: number;
  /** Of each name a script, or null: then the next genome plays. */
  readonly scripts: readonly (ScriptName | null)[];
  readonly policy: PolicyShape | null;
}

/** A world, and what plays in it against a person. */
export interface OpponentsData {
  readonly world: WorldConfig;
  /** The rounds of "Can you escape it?"; none where pursuers of three strengths play in a smaller world. */
  readonly rounds: readonly {
    readonly world: WorldConfig;
    readonly pursuers: ScriptName;
    readonly text: string;
  }[];
  readonly teams: OfTeams<TeamData>;
}

/** The data of the page itself. */
export interface PlaygroundData extends PageData {
  readonly title: string;
  readonly version: string;
  /** Null for a page without games. */
  readonly play: OpponentsData | null;
}

/** Return the data that the page holds; the explorer adds its champions. */
export function pageData(): PlaygroundData {
  const given = JSON.parse(document.getElementById("data")!.textContent!) as PlaygroundData;
  const data = { ...given, scene: document.getElementById("scene")?.textContent ?? given.scene };
  const champions = document.getElementById("champions")?.textContent;
  return champions ? { ...data, champions: JSON.parse(champions, revived) as Champions } : data;
}

/** Genomes are kept as lists: the numbers of JSON give back every float32. */
const revived = (name: string, value: unknown): unknown =>
  name === "genome" ? Float32Array.from(value as number[]) : value;

/** Return the element that tells a playground of champions, as HTML. */
export function championsElement(champions: Champions): string {
  const text = JSON.stringify(champions, (name, value: unknown) =>
    name === "genome" ? Array.from(value as Float32Array) : value,
  );
  return html("script", { type: "application/json", id: "champions" }, text.replaceAll("<", "\\u003c"))
    .outerHTML;
}
