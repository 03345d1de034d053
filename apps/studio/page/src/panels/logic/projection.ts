// Small pictures of a shape: its rods, seen from above at a slant, as one SVG path.

export interface Line {
  /** Indices of nodes, in order. */
  nodes: ArrayLike<number>;
}

export interface Picture {
  path: string;
  viewBox: string;
}

/** Where a point lies in the picture: x to the right and y down, both mm. Looks from the front right, 35 degrees above. */
export function projected(x: number, y: number, z: number): [number, number] {
  const turn = (30 * Math.PI) / 180;
  const tilt = (35 * Math.PI) / 180;
  const across = x * Math.cos(turn) + y * Math.sin(turn);
  const depth = -x * Math.sin(turn) + y * Math.cos(turn);
  return [across, -(z * Math.cos(tilt) + depth * Math.sin(tilt))];
}

/** The lines through `positions` (nodes, 3), from `first` on; `thin`: every so many nodes are drawn. */
export function picture(positions: ArrayLike<number>, lines: readonly Line[], first = 0, thin = 1): Picture {
  let low: [number, number] = [Infinity, Infinity];
  let high: [number, number] = [-Infinity, -Infinity];
  const parts: string[] = [];
  for (const line of lines) {
    const count = line.nodes.length;
    for (let i = 0; i < count; ++i) {
      if (i % thin !== 0 && i !== count - 1) continue;
      const at = 3 * (first + (line.nodes[i] ?? 0));
      const [x, y] = projected(positions[at] ?? 0, positions[at + 1] ?? 0, positions[at + 2] ?? 0);
      low = [Math.min(low[0], x), Math.min(low[1], y)];
      high = [Math.max(high[0], x), Math.max(high[1], y)];
      parts.push(`${i === 0 ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`);
    }
  }
  if (parts.length === 0) return { path: '', viewBox: '0 0 1 1' };
  const margin = 0.06 * Math.max(high[0] - low[0], high[1] - low[1], 1);
  const box = [low[0] - margin, low[1] - margin, high[0] - low[0] + 2 * margin, high[1] - low[1] + 2 * margin];
  return { path: parts.join(''), viewBox: box.map((v) => v.toFixed(1)).join(' ') };
}
