// Which mouse buttons and keys turn, shift and zoom the view: as in the program that people come from. The left button
// is for selecting and dragging, always.

import type { NavigationPreset } from './store';

export type Motion = 'orbit' | 'pan' | 'zoom' | null;

export interface Press {
  /** As in PointerEvent.button: 0 left, 1 middle, 2 right. */
  button: number;
  shiftKey: boolean;
  ctrlKey: boolean;
  metaKey: boolean;
  altKey: boolean;
}

export function motionOf(preset: NavigationPreset, press: Press): Motion {
  const { button } = press;
  const control = press.ctrlKey || press.metaKey;
  switch (preset) {
    case 'rhino':
      if (button === 2) return press.shiftKey ? 'pan' : control ? 'zoom' : 'orbit';
      return button === 1 ? 'pan' : null;
    case 'blender':
      if (button === 1) return press.shiftKey ? 'pan' : control ? 'zoom' : 'orbit';
      return button === 2 ? 'pan' : null;
    case 'cad':
      if (button === 1) return control ? 'pan' : press.shiftKey ? 'zoom' : 'orbit';
      return button === 2 ? 'pan' : null;
    case 'trackpad':
      // A press still has to do something for those who plug in a mouse.
      if (button === 2) return press.shiftKey ? 'pan' : 'orbit';
      return button === 1 ? 'orbit' : null;
  }
}

export interface Wheel {
  deltaX: number;
  deltaY: number;
  /** As in WheelEvent: 0 pixels, 1 lines, 2 pages. */
  deltaMode: number;
  ctrlKey: boolean;
  shiftKey: boolean;
}

const kLine = 18;

/** What a turn of the wheel (or two fingers) does: pixels to orbit or pan by, or a factor to zoom by. */
export function wheelMotion(preset: NavigationPreset, wheel: Wheel): { motion: Motion; dx: number; dy: number; factor: number } {
  const size = wheel.deltaMode === 1 ? kLine : wheel.deltaMode === 2 ? 20 * kLine : 1;
  const dx = -wheel.deltaX * size;
  const dy = -wheel.deltaY * size;
  // Browsers report a pinch as a wheel with Ctrl, in small steps.
  const factor = Math.exp(Math.min(Math.max(-dy, -240), 240) * (wheel.ctrlKey && Math.abs(dy) < 30 ? 0.01 : 0.0016));
  if (preset === 'trackpad' && !wheel.ctrlKey) return { motion: wheel.shiftKey ? 'pan' : 'orbit', dx, dy, factor: 1 };
  return { motion: 'zoom', dx: 0, dy: 0, factor };
}
