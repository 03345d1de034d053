// One legend: histogram, colours, ticks, lock of the range.

import { colourAt, css } from '../../core/colours';
import type { FieldInfo } from '../../core/protocol';
import { tickDigits, ticks } from '../logic/ticks';
import { fixed, short } from '../logic/number_text';
import { Button } from '../parts/button';
import { Field } from '../parts/field';
import { useState } from 'preact/hooks';

interface LegendProps {
  title: string;
  field: FieldInfo;
  low: number;
  high: number;
  locked: boolean;
  /** Values in equal parts of low..high. */
  bins: readonly number[];
  onLock: (on: boolean) => void;
  onRange: (low: number, high: number) => void;
}

/** Units of the drawing are pixels at an interface of 100 %. */
const kWidth = 180;
const kBars = 24;
const kBand = 10;

export function Legend(props: LegendProps) {
  const { title, field, low, high, locked, bins, onLock, onRange } = props;
  const [editing, setEditing] = useState(false);
  const unit = field.unit === '1' ? '' : field.unit;
  const name = `${title}: ${field.name}${unit === '' ? '' : `, ${unit}`}`;
  return (
    <section class="legend-box" aria-label={name}>
      <header class="legend-head">
        <button type="button" class="legend-name" aria-expanded={editing} title="Set the range" onClick={() => setEditing(!editing)}>
          {name}
        </button>
        <Button
          icon={locked ? 'lock' : 'unlock'}
          label={locked ? 'Let the range follow the shape' : 'Lock the range'}
          pressed={locked}
          onClick={() => onLock(!locked)}
        />
      </header>
      <Scale field={field} low={low} high={high} bins={bins} />
      {locked && beyond(field, low, high) && <p class="small soft">Hatched: beyond the range.</p>}
      {editing && (
        <div class="stack legend-range">
          <Field
            label="From"
            unit={unit}
            value={low}
            digits={4}
            step={(high - low) / 20}
            onCommit={(value) => (onRange(value, high), null)}
          />
          <Field label="To" unit={unit} value={high} digits={4} step={(high - low) / 20} onCommit={(value) => (onRange(low, value), null)} />
        </div>
      )}
    </section>
  );
}

/** Some values have no colour of their own, as view/shading.ts has it. */
function beyond(field: FieldInfo, low: number, high: number): boolean {
  const slack = 0.002 * (high - low);
  return field.low < low - slack || field.high > high + slack;
}

function Scale({ field, low, high, bins }: { field: FieldInfo; low: number; high: number; bins: readonly number[] }) {
  const most = Math.max(...bins, 1);
  const wide = kWidth / bins.length;
  const summary = `from ${short(low)} to ${short(high)}; values lie between ${short(field.low)} and ${short(field.high)}`;
  return (
    <>
      <svg class="legend-scale legend-bars" viewBox={`-14 0 ${kWidth + 28} ${kBars}`} aria-hidden="true">
        {bins.map((count, i) => {
          const tall = (Math.sqrt(count / most) * (kBars - 2)) | 0;
          return <rect key={i} x={i * wide + 0.5} y={kBars - tall} width={wide - 1} height={tall} />;
        })}
      </svg>
      <Band field={field} low={low} high={high} parts={bins.length} label={summary} />
    </>
  );
}

interface BandProps {
  field: FieldInfo;
  low: number;
  high: number;
  parts: number;
  label: string;
}

/** Colours and ticks. */
function Band({ field, low, high, parts, label }: BandProps) {
  const wide = kWidth / parts;
  const marks = ticks(low, high, 4);
  const digits = tickDigits(marks);
  const text = (value: number) => (digits > 4 ? short(value, 2) : fixed(value, digits));
  return (
    <svg class="legend-scale" viewBox={`-14 0 ${kWidth + 28} ${kBand + 20}`} role="img" aria-label={label}>
      {Array.from({ length: parts }, (_, i) => (
        <rect key={i} x={i * wide} width={wide + 0.5} height={kBand} fill={css(colourAt(field.diverging, (i + 0.5) / parts))} />
      ))}
      {marks.map((value) => {
        const x = ((value - low) / (high - low)) * kWidth;
        return (
          <g key={value}>
            <line class="legend-tick" x1={x} x2={x} y1={kBand} y2={kBand + 3} />
            <text class="legend-text" x={x} y={kBand + 15} text-anchor="middle">
              {text(value)}
            </text>
          </g>
        );
      })}
    </svg>
  );
}
