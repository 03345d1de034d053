// How the distance to the target falls, step by step.

import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { FitEvent } from '../../core/protocol';
import { dark, uiScale } from '../../core/store';
import { short } from '../logic/number_text';

const kHeight = 150;

export function FitPlot({ records }: { records: FitEvent['records'] }) {
  const place = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const theme = `${dark.value} ${uiScale.value}`;
  useEffect(() => {
    const element = place.current;
    if (!element) return undefined;
    const made = new uPlot(options(element), [[], []], element);
    plot.current = made;
    const resize = new ResizeObserver(() => made.setSize({ width: element.clientWidth, height: kHeight }));
    resize.observe(element);
    return () => {
      resize.disconnect();
      made.destroy();
    };
  }, [theme]);
  useEffect(() => plot.current?.setData(dataOf(records)), [records, theme]);
  const first = records[0];
  const last = records[records.length - 1];
  const summary =
    first && last
      ? `Distance to the target by iteration: from ${short(first.distance_mm)} mm to ${short(last.distance_mm)} mm in ${last.iteration} iterations`
      : 'Distance to the target by iteration: nothing yet';
  return <div ref={place} class="plot" role="img" aria-label={summary} />;
}

/** A log axis shows no zero. */
function dataOf(records: FitEvent['records']): uPlot.AlignedData {
  return [records.map((r) => r.iteration), records.map((r) => Math.max(r.distance_mm, 1e-6))];
}

function options(element: HTMLElement): uPlot.Options {
  const style = getComputedStyle(element);
  const font = `11px ${style.fontFamily}`;
  const line = style.borderTopColor;
  const axis = { stroke: style.color, font, grid: { stroke: line, width: 1 }, ticks: { stroke: line, width: 1, size: 4 } };
  return {
    width: element.clientWidth,
    height: kHeight,
    legend: { show: false },
    cursor: { show: false },
    scales: { x: { time: false }, y: { distr: 3 } },
    axes: [
      { ...axis, label: 'Iteration', labelFont: font, labelSize: 16, size: 24, incrs: [1, 2, 5, 10, 20, 50, 100] },
      { ...axis, label: 'Distance, mm', labelFont: font, labelSize: 16, size: 44, values: (_, marks) => marks.map((m) => (m === null ? '' : short(m, 1))) },
    ],
    series: [{}, { stroke: style.accentColor, width: 1.5, points: { show: true, size: 5 } }],
  };
}
