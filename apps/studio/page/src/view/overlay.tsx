// What is drawn over the 3D picture with pen and ink: box and lasso, the handle and its soft radius, the scale, the label at the pointer.

import { Projector, scaleOf } from '../core/camera';
import { pixelAt, poseText } from '../core/gizmo';
import { gizmoPlace } from '../core/handles';
import { niceLength } from '../core/scale_bar';
import * as store from '../core/store';
import { Gizmo } from './gizmo_overlay';
import { label, marquee, typed } from './local';

function points(corners: readonly (readonly [number, number])[]): string {
  return corners.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ');
}

function Marquee() {
  const shown = marquee.value;
  if (!shown) return null;
  return <polygon class={shown.touching ? 'marquee touching' : 'marquee'} points={points(shown.corners)} />;
}

/** The handle, the soft radius about it, and what the handle has been asked for. */
function Handle() {
  const center = store.workMode.value === 'shape' ? gizmoPlace() : null;
  if (!center) return null;
  const projector = new Projector(store.camera.value, store.viewSize.value);
  const at = projector.point(center);
  if (!at) return null;
  const radius = store.softRadius.value / pixelAt(projector, center);
  const text = typed.value !== '' ? typed.value : poseText(store.handlePose.value);
  return (
    <g>
      <Gizmo projector={projector} center={center} />
      <circle class="soft-radius" cx={at[0]} cy={at[1]} r={radius} />
      {text !== '' && (
        <text class="overlay-text strong" x={at[0] + 14} y={at[1] - 14}>
          {text}
        </text>
      )}
      <text class="overlay-text" x={at[0]} y={at[1] - radius - 5} text-anchor="middle">
        {`soft radius ${store.softRadius.value.toFixed(1)} mm`}
      </text>
    </g>
  );
}

function ScaleBar() {
  const size = store.viewSize.value;
  if (size.width < 200) return null;
  const step = scaleOf(store.camera.value, size);
  const length = niceLength(110 * step);
  const width = length / step;
  const x = size.width - 18 - width;
  const y = size.height - 14;
  return (
    <g>
      <path class="scale-bar" d={`M${x} ${y - 5}V${y}H${x + width}V${y - 5}`} />
      <text class="overlay-text" x={x + width / 2} y={y - 6} text-anchor="middle">
        {`${length} mm`}
      </text>
    </g>
  );
}

function Label() {
  const shown = label.value;
  if (!shown || marquee.value) return null;
  const right = shown.at[0] > store.viewSize.value.width - 170;
  return (
    <text class="overlay-text strong" x={shown.at[0] + (right ? -12 : 14)} y={shown.at[1] - 10} text-anchor={right ? 'end' : 'start'}>
      {shown.text}
    </text>
  );
}

export function Overlay() {
  return (
    <svg class="view-overlay" aria-hidden="true">
      <ScaleBar />
      <Handle />
      <Marquee />
      <Label />
    </svg>
  );
}
