// Draws what lies over the plan: the sketch of the active tool, box and lasso, rulers in mm.

import { css } from '../core/colours';
import type { Vec2 } from '../core/protocol';
import { marks, niceStep } from '../core/scale_bar';
import { middleOf } from '../core/snapping';
import { rgba, trace } from './plan_paint';
import type { PlanScene } from './plan_scene';

type Pen = CanvasRenderingContext2D;

export const kRuler = 20;

/** The live layer's part: the sketch of the tool, box and lasso, where the pointer is on the rulers. */
export function paintOver(pen: Pen, scene: PlanScene): void {
  paintSketch(pen, scene);
  paintMarquee(pen, scene);
  paintHovered(pen, scene);
}

/** The name of what is hovered, here or elsewhere; a tool that says something has the word. */
function paintHovered(pen: Pen, scene: PlanScene): void {
  const { plan, hover, moves, sketch, marquee } = scene;
  if (!plan || !hover || sketch.texts.length > 0 || marquee || moves.size > 0) return;
  const point = hover.kind === 'point' ? plan.points.find((p) => p.name === hover.name)?.at_mm : undefined;
  const rod = hover.kind === 'rod' ? plan.rods.find((r) => r.name === hover.name) : undefined;
  const at = point ?? (rod && middleOf(rod.line_mm));
  if (!at) return;
  pen.font = '600 12px system-ui, sans-serif';
  const text = rod ? `${rod.name}, ${rod.length_mm.toFixed(1)} mm` : hover.name;
  plate(pen, text, scene.pixel(at), scene);
}

function paintSketch(pen: Pen, scene: PlanScene): void {
  const { sketch, palette, pixel } = scene;
  if (sketch.guide) {
    pen.setLineDash([2, 4]);
    pen.lineWidth = 1;
    pen.strokeStyle = css(palette.pin);
    trace(pen, sketch.guide, pixel);
    pen.stroke();
    pen.setLineDash([]);
  }
  for (const { line, closed, faint } of sketch.lines) {
    trace(pen, line, pixel, closed);
    pen.lineWidth = faint ? 1.5 : 2.5;
    pen.strokeStyle = rgba(palette.select, faint ? 0.6 : 1);
    pen.setLineDash(faint ? [5, 4] : []);
    pen.stroke();
  }
  pen.setLineDash([]);
  for (const at of sketch.points) dot(pen, pixel(at), 4, css(palette.select));
  if (sketch.cursor) {
    const [x, y] = pixel(sketch.cursor);
    pen.beginPath();
    pen.arc(x, y, 6, 0, 2 * Math.PI);
    pen.lineWidth = 1.5;
    pen.strokeStyle = css(palette.select);
    pen.stroke();
  }
  pen.font = '600 12px system-ui, sans-serif';
  for (const { at, text } of sketch.texts) plate(pen, text, scene.pixel(at), scene);
}

function dot(pen: Pen, [x, y]: Vec2, radius: number, fill: string): void {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fillStyle = fill;
  pen.fill();
}

/** Text on a plate of its own: a halo of strokes takes five times as long. */
function plate(pen: Pen, text: string, [x, y]: Vec2, { palette, size }: PlanScene): void {
  const [ink, ground, right] = [css(palette.ink), css(palette.ground), size.width];
  pen.textAlign = 'left';
  pen.textBaseline = 'alphabetic';
  const width = Math.ceil(pen.measureText(text).width) + 6;
  const left = Math.round(x + 9 + width > right ? x - 9 - width : x + 9);
  const top = Math.round(y - 23 < kRuler ? y + 9 : y - 23);
  pen.fillStyle = ground;
  pen.fillRect(left, top, width, 18);
  pen.fillStyle = ink;
  pen.fillText(text, left + 3, top + 13);
}

function paintMarquee(pen: Pen, { marquee, palette, pixel }: PlanScene): void {
  if (!marquee) return;
  trace(pen, marquee.corners, pixel, true);
  pen.lineWidth = 1;
  pen.setLineDash(marquee.touching ? [5, 4] : []);
  pen.fillStyle = rgba(palette.pin, 0.08);
  pen.strokeStyle = css(palette.pin);
  pen.fill();
  pen.stroke();
  pen.setLineDash([]);
}

/** Rulers in mm along the top and the left. */
export function paintRulers(pen: Pen, { camera, size, palette }: PlanScene): void {
  const step = niceStep(8 / camera.pixels_per_mm);
  const { center_mm: c, pixels_per_mm: s } = camera;
  pen.fillStyle = rgba(palette.ground, 0.92);
  pen.fillRect(0, 0, size.width, kRuler);
  pen.fillRect(0, 0, kRuler, size.height);
  pen.strokeStyle = rgba(palette.inkSoft, 0.45);
  pen.lineWidth = 1;
  pen.beginPath();
  pen.moveTo(kRuler + 0.5, size.height);
  pen.lineTo(kRuler + 0.5, kRuler + 0.5);
  pen.lineTo(size.width, kRuler + 0.5);
  pen.font = '10px system-ui, sans-serif';
  pen.fillStyle = css(palette.inkSoft);
  pen.textBaseline = 'top';
  pen.textAlign = 'left';
  for (const { at, label } of marks(c[0] - size.width / 2 / s, c[0] + size.width / 2 / s, step)) {
    const x = Math.round(size.width / 2 + (at - c[0]) * s) + 0.5;
    if (x < kRuler) continue;
    pen.moveTo(x, kRuler);
    pen.lineTo(x, label !== '' ? 8 : 15);
    if (label !== '' && x > kRuler + 24) pen.fillText(label, x + 2, 4);
  }
  for (const { at, label } of marks(c[1] - size.height / 2 / s, c[1] + size.height / 2 / s, step)) {
    const y = Math.round(size.height / 2 - (at - c[1]) * s) + 0.5;
    if (y < kRuler) continue;
    pen.moveTo(kRuler, y);
    pen.lineTo(label !== '' ? 8 : 15, y);
    if (label === '') continue;
    pen.save();
    pen.translate(4, y - 2);
    pen.rotate(-Math.PI / 2);
    pen.fillText(label, 0, 0);
    pen.restore();
  }
  pen.stroke();
  pen.fillStyle = css(palette.ground);
  pen.fillRect(0, 0, kRuler, kRuler);
  pen.fillStyle = css(palette.inkSoft);
  pen.fillText('mm', 2, 5);
}

/** Where the pointer is, on both rulers. */
export function paintRulerCursor(pen: Pen, { sketch, palette, pixel }: PlanScene): void {
  if (!sketch.cursor) return;
  const [x, y] = pixel(sketch.cursor).map(Math.round);
  pen.fillStyle = css(palette.select);
  pen.fillRect(x, 0, 1, kRuler);
  pen.fillRect(0, y, kRuler, 1);
}
