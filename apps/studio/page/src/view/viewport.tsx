// The 3D view as a component. Panels place it once; it fills its container (position: relative, any size) and follows
// its size. Children are laid over the picture (legend, mode strip).

import type { ComponentChildren } from 'preact';

export function Viewport({ children }: { children?: ComponentChildren }) {
  return <div class="viewport">{children}</div>;
}
