// Viridis, as in the package's figures: the same order in grey and for colour-blind readers.

// Sixteen colours of Matplotlib's table at equal distances (van der Walt and Smith 2015).
const ANCHORS: readonly (readonly [number, number, number])[] = [
  [68, 1, 84],
  [72, 26, 108],
  [71, 47, 125],
  [65, 68, 135],
  [57, 86, 140],
  [49, 104, 142],
  [42, 120, 142],
  [35, 136, 142],
  [31, 152, 139],
  [34, 168, 132],
  [53, 183, 121],
  [84, 197, 104],
  [122, 209, 81],
  [165, 219, 54],
  [210, 226, 27],
  [253, 231, 37],
];

/** Return red, green and blue, 0 to 255, of a rate from 0 to 1. */
export function viridis(rate: number): readonly [number, number, number] {
  const place = Math.min(1, Math.max(0, rate)) * (ANCHORS.length - 1);
  const low = Math.min(ANCHORS.length - 2, Math.floor(place));
  const a = ANCHORS[low]!;
  const b = ANCHORS[low + 1]!;
  const mix = (i: 0 | 1 | 2): number => Math.round(a[i] + (place - low) * (b[i] - a[i]));
  return [mix(0), mix(1), mix(2)];
}

/** Return the colour of text that can be read on a rate's colour: with a contrast of at least 4.5. */
export function inkOn(rate: number): "#000" | "#fff" {
  const [red, green, blue] = viridis(rate).map((each) => ((each / 255 + 0.055) / 1.055) ** 2.4);
  return 0.2126 * red! + 0.7152 * green! + 0.0722 * blue! > 0.179 ? "#000" : "#fff";
}

export const viridisText = (rate: number): string => `rgb(${viridis(rate).join(" ")})`;

/** Return stops of a CSS gradient that shows the scale. */
export const viridisGradient = (): string =>
  `linear-gradient(to right, ${ANCHORS.map((color) => `rgb(${color.join(" ")})`).join(", ")})`;
