// The view cube: six buttons turned in space by the style sheet's 3D transforms, so that keyboard and screen reader reach
// each face by its name. The picture behind it is drawn by three; this costs it nothing.

import { useEffect, useRef } from 'preact/hooks';
import { effect } from '@preact/signals-core';
import { axesOf } from '../core/camera';
import { run } from '../core/commands';
import { camera, type NamedView } from '../core/store';

const faces: { view: NamedView; title: string }[] = [
  { view: 'top', title: 'Top' },
  { view: 'front', title: 'Front' },
  { view: 'right', title: 'Right' },
  { view: 'back', title: 'Back' },
  { view: 'left', title: 'Left' },
  { view: 'bottom', title: 'Bottom' },
];

export function ViewCube() {
  const body = useRef<HTMLDivElement>(null);
  useEffect(
    () =>
      effect(() => {
        const { right, up, back } = axesOf(camera.value);
        // Columns: where the axes of the object go on the screen, whose y axis runs down.
        const columns = [0, 1, 2].map((k) => [right[k], -up[k], back[k], 0].map((x) => x.toFixed(5)).join(','));
        body.current?.style.setProperty('transform', `matrix3d(${columns.join(',')},0,0,0,1)`);
      }),
    [],
  );
  return (
    <div class="view-cube" role="group" aria-label="View from">
      <div class="view-cube-body" ref={body}>
        {faces.map(({ view, title }) => (
          <button key={view} type="button" class={`view-cube-face ${view}`} title={`View from: ${title}`} onClick={() => run(`view.${view}`)}>
            {title}
          </button>
        ))}
      </div>
      <button type="button" class="view-cube-home" title="Home view" onClick={() => run('view.home')}>
        Home
      </button>
    </div>
  );
}
