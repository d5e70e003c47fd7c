// What Python tells the page: the variants, the fields of rules with their values, the scripts, the
// rewards and the gallery. The page adds nothing to it, so that page and package cannot diverge.

import { html } from "../page/dom.ts";
import type { Rewards, Rules, ScriptName, TeamPolicy } from "../engine/types.ts";

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
export interface Champion {
  readonly name: string;
  readonly policy: TeamPolicy;
}
export type Champions = Readonly<Record<"pursuer" | "evader", Champion>>;

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

/** Return the data that the page holds; the explorer adds its champions. */
export function pageData(): PageData {
  const data = JSON.parse(document.getElementById("data")!.textContent!) as PageData;
  const champions = document.getElementById("champions")?.textContent;
  return champions ? { ...data, champions: JSON.parse(champions, revived) as Champions } : data;
}

/** Genomes are kept as lists: the numbers of JSON give back every float32. */
const revived = (name: string, value: unknown): unknown => (name === "genome" ? Float32Array.from(value as number[]) : value);

/** Return the element that tells a playground of champions, as HTML. */
export function championsElement(champions: Champions): string {
  const text = JSON.stringify(champions, (name, value: unknown) => (name === "genome" ? Array.from(value as Float32Array) : value));
  return html("script", { type: "application/json", id: "champions" }, text.replaceAll("<", "\\u003c")).outerHTML;
}
