// What only the 3D view needs to remember: the marquee, the grip under the pointer, the label beside the pointer.

import { signal } from '@preact/signals-core';
import type { Grip } from '../core/gizmo';
import type { Vec2 } from '../core/vec';

/** Corners of the box or lasso being drawn, pixels. */
export const marquee = signal<{ corners: Vec2[]; touching: boolean } | null>(null);
export const hotGrip = signal<Grip | null>(null);
export const label = signal<{ at: Vec2; text: string } | null>(null);
/** Digits typed while a handle is held ("x 12.5"); empty: none. */
export const typed = signal('');
