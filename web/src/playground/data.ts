// What Python tells the page: the variants, the fields of rules with their values, the scripts, the
// rewards and the gallery. The page adds nothing to it, so that page and package cannot diverge.

import type { Rewards, Rules, ScriptName } from "../engine/types.ts";

export interface Field {
  readonly name: keyof Rules;
  readonly label: string;
  readonly text: string;
  readonly values: readonly { readonly name: string; readonly label: string }[];
}

export interface Example {
  readonly title: string;
  readonly text: string;
  /** A scene as it stands in a link. */
  readonly scene: string;
}

export interface PageData {
  readonly variants: Readonly<Record<string, Rules>>;
  readonly titles: Readonly<Record<string, string>>;
  readonly fields: readonly Field[];
  readonly rewards: Readonly<Record<string, Rewards>>;
  readonly scripts: readonly { readonly name: ScriptName; readonly text: string }[];
  readonly gallery: readonly Example[];
  /** The scene to begin with where the address names none. */
  readonly scene: string;
}

/** Return the data that the page holds. */
export function pageData(): PageData {
  return JSON.parse(document.getElementById("data")!.textContent!) as PageData;
}
