// Draws the combined handle (core/gizmo.ts has its geometry).

import type { Colour } from '../core/colours';
import { gripLines, kAxes, type Grip } from '../core/gizmo';
import type { Projector } from '../core/camera';
import type { GizmoKind } from '../core/store';
import type { Vec3 } from '../core/vec';
import type { Marker } from './markers';
import type { Palette } from './palette';
import type { Stroke } from './screen_lines';
import type { View } from './view';

/** Turns of the arrows' tips from +z. */
const kTurns: Record<'x' | 'y' | 'z', [number, number, number, number]> = {
  x: [0, Math.SQRT1_2, 0, Math.SQRT1_2],
  y: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2],
  z: [0, 0, 0, 1],
};

function colourOf(grip: Grip, palette: Palette): Colour {
  const axis = 'xyz'.indexOf(grip.at(-1) ?? '');
  return grip === 'scale' || grip === 'screen' || axis < 0 ? palette.select : palette.axes[axis];
}

function kindOf(grip: Grip): GizmoKind {
  return grip === 'scale' ? 'scale' : grip.startsWith('turn') ? 'rotate' : 'move';
}

/** Draws the gizmo at a place, or takes it away (null). The chosen kind stands out; all of them can be gripped. */
export function drawGizmo(view: View, projector: Projector | null, center: Vec3 | null, hot: Grip | null, kind: GizmoKind): void {
  if (!projector || !center) {
    view.lines.gizmo.set([]);
    view.markers.tips.set([]);
    view.markers.knobs.set([]);
    return;
  }
  const { palette } = view;
  const strokes: Stroke[] = [];
  const tips: Marker[] = [];
  const knobs: Marker[] = [{ place: center, colour: hot === 'screen' ? palette.hover : palette.select, size: hot === 'screen' ? 15 : 12 }];
  for (const { grip, line } of gripLines(projector, center)) {
    const colour = grip === hot ? palette.hover : colourOf(grip, palette);
    const width = grip === hot ? 4.5 : kindOf(grip) === kind ? 3 : 1.5;
    for (let i = 1; i < line.length; ++i) strokes.push({ from: line[i - 1], to: line[i], colour, width });
    const end = line[line.length - 1];
    if (grip in kAxes) tips.push({ place: end, colour, size: grip === hot ? 22 : 18, turn: kTurns[grip as 'x' | 'y' | 'z'] });
    if (grip === 'scale') knobs.push({ place: end, colour, size: grip === hot ? 13 : 10 });
  }
  view.lines.gizmo.set(strokes);
  view.markers.tips.set(tips);
  view.markers.knobs.set(knobs);
}
