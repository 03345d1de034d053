// Draws legends into a picture, as they stand on the page.

import { colourAt, css } from '../../core/colours';
import type { FieldInfo } from '../../core/protocol';
import { fixed } from '../logic/number_text';
import { tickDigits, ticks } from '../logic/ticks';

export interface PaintedLegend {
  title: string;
  field: FieldInfo;
  low: number;
  high: number;
}

const kWidth = 240;
const kHeight = 56;
const kMargin = 16;
const kSteps = 64;

/** Into the lower left corner, one above the other; `ratio`: pixels of the picture per pixel of the page. */
export function paintLegends(canvas: HTMLCanvasElement, legends: readonly PaintedLegend[], ratio: number, ink: string): void {
  const pen = canvas.getContext('2d');
  if (!pen) return;
  legends.forEach((legend, k) => {
    pen.save();
    pen.scale(ratio, ratio);
    pen.translate(kMargin, canvas.height / ratio - kMargin - (legends.length - k) * kHeight);
    paint(pen, legend, ink);
    pen.restore();
  });
}

function paint(pen: CanvasRenderingContext2D, { title, field, low, high }: PaintedLegend, ink: string): void {
  const unit = field.unit === '' || field.unit === '1' ? '' : `, ${field.unit}`;
  pen.font = '12px system-ui, sans-serif';
  pen.fillStyle = ink;
  pen.textBaseline = 'top';
  pen.textAlign = 'left';
  pen.fillText(`${title}: ${field.name}${unit}`, 0, 0);
  for (let i = 0; i < kSteps; ++i) {
    pen.fillStyle = css(colourAt(field.diverging, (i + 0.5) / kSteps));
    pen.fillRect((i * kWidth) / kSteps, 18, kWidth / kSteps + 0.5, 10);
  }
  const marks = ticks(low, high, 4);
  const digits = tickDigits(marks);
  pen.fillStyle = ink;
  pen.textAlign = 'center';
  for (const value of marks) {
    const x = ((value - low) / (high - low)) * kWidth;
    pen.fillRect(x - 0.5, 28, 1, 4);
    pen.fillText(fixed(value, digits), x, 34);
  }
}
