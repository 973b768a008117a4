// Color maps and how codes become pixels. Pixels are words of ImageData: 0xAABBGGRR on every machine that runs a browser today.

/** Anchors of the color maps viridis and inferno (matplotlib, CC0), evenly spaced. */
const VIRIDIS = [0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21918c, 0x22a884, 0x44bf70, 0x7ad151, 0xbddf26, 0xfde725];
const INFERNO = [0x000004, 0x160b39, 0x420a68, 0x6a176e, 0x932667, 0xbc3754, 0xdd513a, 0xf37819, 0xfca50a, 0xf6d746, 0xfcffa4];
/** Too small or too dark (blue) over right (gray) to too large or too bright (red). */
const DEVIATION = [0x1d56b0, 0x6b96d6, 0xd3d8de, 0xe79683, 0xc7361f];

export type Map = (share: number) => number;

/** A word of ImageData from 0xRRGGBB and an opacity. */
export function word(rgb: number, opacity = 255): number {
  return ((opacity << 24) | ((rgb & 0xff) << 16) | (rgb & 0xff00) | (rgb >> 16)) >>> 0;
}

/** The CSS color of a word. */
export function css(pixel: number): string {
  return `rgb(${pixel & 255} ${(pixel >> 8) & 255} ${(pixel >> 16) & 255} / ${((pixel >>> 24) / 255).toFixed(3)})`;
}

function between(anchors: number[], share: number): number {
  const place = Math.min(Math.max(share, 0), 1) * (anchors.length - 1);
  const i = Math.min(Math.floor(place), anchors.length - 2);
  const channel = (shift: number) => {
    const [from, to] = [(anchors[i] >> shift) & 255, (anchors[i + 1] >> shift) & 255];
    return Math.round(from + (place - i) * (to - from)) << shift;
  };
  return word(channel(16) | channel(8) | channel(0));
}

export const viridis: Map = (share) => between(VIRIDIS, share);
export const inferno: Map = (share) => between(INFERNO, share);
export const deviation: Map = (share) => between(DEVIATION, share);

/** Red, green and blue of a word, 0…1. */
export function channels(pixel: number): [number, number, number] {
  return [(pixel & 255) / 255, ((pixel >> 8) & 255) / 255, ((pixel >> 16) & 255) / 255];
}

/** A color of the style sheet, as a word. Dark and light mode have their own. */
export function token(name: string): number {
  const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  return word(Number.parseInt(text.slice(1), 16) || 0);
}

/** The word with another opacity. */
export function faded(pixel: number, opacity: number): number {
  return ((pixel & 0xffffff) | (Math.round(255 * opacity) << 24)) >>> 0;
}

export interface Scale {
  low: number;
  high: number;
  logarithmic: boolean;
  map: Map;
}

/** Where a value lies on a scale, 0…1. */
export function place(scale: Scale, value: number): number {
  const { low, high, logarithmic } = scale;
  if (!(high > low)) return 0;
  if (logarithmic) return Math.log(Math.max(value, low) / low) / Math.log(high / low);
  return (value - low) / (high - low);
}

/** The pixel of every code: transparent where there is no value. */
export function palette(values: Float32Array, scale: Scale): Uint32Array {
  return Uint32Array.from(values, (value) => (Number.isNaN(value) ? 0 : scale.map(place(scale, value))));
}
