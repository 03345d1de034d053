// A picture of the shape as it is shown, twice as large as on screen.

import { fabricField, fabricRange, rodField, rodRange, shape } from '../../core/store';
import { currentView } from '../../view/current';
import { paintLegends, type PaintedLegend } from './legend_paint';

const kRatio = 2;

/** PNG as base64, or null where nothing is shown. */
export async function takePicture(legends: boolean): Promise<string | null> {
  const view = currentView();
  if (!view || !shape.peek()) return null;
  const canvas = await view.capture(kRatio, false);
  if (canvas.width < 2) return null;
  if (legends) paintLegends(canvas, shownLegends(), kRatio, getComputedStyle(document.body).color);
  return canvas.toDataURL('image/png').replace(/^data:image\/png;base64,/, '');
}

function shownLegends(): PaintedLegend[] {
  const now = shape.peek();
  const out: PaintedLegend[] = [];
  if (now && rodField.peek() !== '') out.push({ title: 'Rods', field: now.field_rods, ...rodRange.peek() });
  if (now && fabricField.peek() !== '') out.push({ title: 'Fabric', field: now.field_fabric, ...fabricRange.peek() });
  return out;
}
