// Colours of a board: CSS variables of board.css, so that light and dark themes are one place.

/** Colours of the board alone, whose variables begin with "--board-", and those that the page uses, too. */
const OF_BOARD = ["paper", "line", "frame", "ink", "muted", "obstacle"] as const;
const OF_PAGE = ["pursuer", "evader", "capture", "collision", "focus"] as const;

export type Palette = Readonly<Record<(typeof OF_BOARD | typeof OF_PAGE)[number], string>>;

/** Return the colours that apply to an element. */
export function paletteOf(element: Element): Palette {
  const style = getComputedStyle(element);
  const entry = (name: string, prefix: string): [string, string] => [
    name,
    style.getPropertyValue(prefix + name).trim(),
  ];
  return Object.fromEntries([
    ...OF_BOARD.map((name) => entry(name, "--board-")),
    ...OF_PAGE.map((name) => entry(name, "--")),
  ]) as Palette;
}
