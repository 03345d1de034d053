// Tools that do one thing to what is clicked.

import type { PlanPointer, Tool } from './tool';
import { emptySketch, sketch } from '../core/sketch';
import { lookOnly, toolHint, type WorkMode } from '../core/store';

interface ClickTool {
  id: string;
  title: string;
  keys: string[];
  icon: string;
  help: string;
  modes?: WorkMode[];
  /** Whether the place of the click matters, so that it snaps. */
  draws?: boolean;
  click: (pointer: PlanPointer) => void;
}

export function clickTool({ id, title, keys, icon, help, modes, draws, click }: ClickTool): Tool {
  return {
    id,
    title,
    keys,
    icon,
    help,
    modes: modes ?? ['draw'],
    draws,
    start: () => (toolHint.value = help),
    stop: () => (sketch.value = emptySketch),
    down: (pointer) => {
      if (!lookOnly.peek()) click(pointer);
    },
    move: (pointer) => {
      sketch.value = draws ? { ...emptySketch, cursor: pointer.snap.at, guide: pointer.snap.guide } : emptySketch;
    },
  };
}
