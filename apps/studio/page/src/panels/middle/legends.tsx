// What the colours mean: of the rods and of the fabric, over the lower left corner of the shape.

import { effect, signal, type Signal } from '@preact/signals';
import { useEffect, useRef, useState } from 'preact/hooks';
import { lockRange } from '../../core/fields';
import type { FieldInfo, ShapePack } from '../../core/protocol';
import { fabricField, fabricRange, rodField, rodRange, shape, type LegendRange } from '../../core/store';
import { histogram } from '../logic/ticks';
import { Legend } from './legend';

/** What a legend says of the present shape; follows it a few times a second, not at every iterate. */
interface Said {
  field: FieldInfo;
  values: Float32Array;
}

const kBins = 40;
const kPause = 200;

export function Legends() {
  return (
    <div class="legends">
      <Followed title="Rods" name={rodField} range={rodRange} of={(pack) => ({ field: pack.field_rods, values: pack.edge_values })} />
      <Followed
        title="Fabric"
        name={fabricField}
        range={fabricRange}
        of={(pack) => ({ field: pack.field_fabric, values: pack.triangle_values })}
      />
    </div>
  );
}

interface FollowedProps {
  title: string;
  name: Signal<string>;
  range: Signal<LegendRange>;
  of: (pack: ShapePack) => Said;
}

function Followed({ title, name, range, of }: FollowedProps) {
  const [said] = useState(() => signal<Said | null>(null));
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  useEffect(() => {
    const end = effect(() => {
      const pack = shape.value;
      if (!pack || timer.current !== undefined) return;
      timer.current = setTimeout(() => {
        timer.current = undefined;
        const now = shape.peek();
        if (now) said.value = of(now);
      }, kPause);
    });
    return () => {
      end();
      clearTimeout(timer.current);
    };
  }, []);
  const now = said.value;
  if (name.value === '' || !now?.field || now.values.length === 0) return null;
  const { low, high, locked } = range.value;
  return (
    <Legend
      title={title}
      field={now.field}
      low={low}
      high={high}
      locked={locked}
      bins={histogram(now.values, low, high, kBins)}
      onLock={(on) => (range.value = { low, high, locked: on })}
      onRange={(from, to) => lockRange(range, from, to)}
    />
  );
}
