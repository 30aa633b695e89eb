// Numbers as the block stream writes them.

/** Rounded to six decimals, as computed values are. */
export function micro(value: number): number {
  const rounded = Math.round(value * 1e6) / 1e6;
  return rounded === 0 ? 0 : rounded;
}
