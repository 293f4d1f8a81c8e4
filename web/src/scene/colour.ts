// Colours of warp angles: from dark blue over green to yellow, of steadily growing lightness, so that they read without hue and in grey.

export type Rgb = [number, number, number];

// Chosen so that the lightness L* of CIELAB goes up by about 12 from one to the next.
const stops: Rgb[] = [
  [0.16, 0.11, 0.35],
  [0.2, 0.25, 0.53],
  [0.17, 0.4, 0.57],
  [0.13, 0.54, 0.55],
  [0.25, 0.67, 0.46],
  [0.56, 0.78, 0.3],
  [0.98, 0.88, 0.25],
];

/** The colour of a share from 0 to 1; beyond, that of the nearer end. */
export function warpColour(share: number): Rgb {
  const place = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const i = Math.min(Math.floor(place), stops.length - 2);
  const [low, high] = [stops[i] as Rgb, stops[i + 1] as Rgb];
  const mix = (k: 0 | 1 | 2) => low[k] + (place - i) * (high[k] - low[k]);
  return [mix(0), mix(1), mix(2)];
}

/** The same for a style sheet. */
export function warpStyle(share: number): string {
  return `rgb(${warpColour(share).map((part) => Math.round(255 * part)).join(" ")})`;
}

/** L* of CIELAB, 0 for black and 100 for white. */
export function lightness([r, g, b]: Rgb): number {
  const linear = (x: number) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
  const y = 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  return y > 216 / 24389 ? 116 * Math.cbrt(y) - 16 : (24389 / 27) * y;
}
