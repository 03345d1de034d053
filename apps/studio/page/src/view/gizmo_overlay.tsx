// The combined handle, drawn over the 3D picture (core/gizmo.ts has its geometry): it follows the pointer without a new
// picture, which takes two frames of the screen where the processor draws.

import type { Projector } from '../core/camera';
import type { Colour } from '../core/colours';
import { gripLines, kAxes, type Grip } from '../core/gizmo';
import * as store from '../core/store';
import type { GizmoKind } from '../core/store';
import type { Vec2, Vec3 } from '../core/vec';
import { hotGrip } from './local';
import { paletteOf, type Palette } from './palette';

/** An arrow that points at the eye has no length to point along, pixels. */
const kSeenAlong = 4;

function colourOf(grip: Grip, palette: Palette): Colour {
  const axis = 'xyz'.indexOf(grip.at(-1) ?? '');
  return grip === 'scale' || grip === 'screen' || axis < 0 ? palette.select : palette.axes[axis];
}

function kindOf(grip: Grip): GizmoKind {
  return grip === 'scale' ? 'scale' : grip.startsWith('turn') ? 'rotate' : 'move';
}

const ink = ([r, g, b]: Colour) => `rgb(${r} ${g} ${b})`;
const corner = ([x, y]: Vec2) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** The head of an arrow whose line ends at `end`: a triangle, a disc where it points along the line of sight. */
function Tip({ from, end, size, fill }: { from: Vec2; end: Vec2; size: number; fill: string }) {
  const way: Vec2 = [end[0] - from[0], end[1] - from[1]];
  const length = Math.hypot(...way);
  if (length < kSeenAlong) return <circle cx={end[0]} cy={end[1]} r={size / 3} fill={fill} />;
  const along: Vec2 = [(way[0] / length) * size, (way[1] / length) * size];
  const at = (a: number, b: number): Vec2 => [end[0] + a * along[0] - b * along[1], end[1] + a * along[1] + b * along[0]];
  return <path d={`M${corner(at(0.6, 0))}L${corner(at(-0.4, 0.34))}L${corner(at(-0.4, -0.34))}Z`} fill={fill} />;
}

function Knob({ at: [x, y], size, fill }: { at: Vec2; size: number; fill: string }) {
  return <rect x={x - size / 2} y={y - size / 2} width={size} height={size} rx={2} fill={fill} />;
}

/** The chosen kind stands out; all of them can be gripped. */
export function Gizmo({ projector, center }: { projector: Projector; center: Vec3 }) {
  const palette = paletteOf(store.dark.value);
  const hot = hotGrip.value;
  const kind = store.gizmoKind.value;
  const middle = projector.point(center);
  if (!middle) return null;
  return (
    <g class="gizmo">
      {gripLines(projector, center).map(({ grip, line }) => {
        const seen = line.map((place) => projector.point(place));
        if (!seen.every((place) => place !== null)) return null;
        const colour = ink(grip === hot ? palette.hover : colourOf(grip, palette));
        const [from, end] = [seen[0], seen[seen.length - 1]].map(([x, y]): Vec2 => [x, y]);
        return (
          <g key={grip}>
            <path
              d={`M${seen.map(([x, y]) => corner([x, y])).join('L')}`}
              stroke={colour}
              stroke-width={grip === hot ? 4.5 : kindOf(grip) === kind ? 3 : 1.5}
            />
            {grip in kAxes && <Tip from={from} end={end} size={grip === hot ? 22 : 18} fill={colour} />}
            {grip === 'scale' && <Knob at={end} size={grip === hot ? 13 : 10} fill={colour} />}
          </g>
        );
      })}
      <Knob at={[middle[0], middle[1]]} size={hot === 'screen' ? 15 : 12} fill={ink(hot === 'screen' ? palette.hover : palette.select)} />
    </g>
  );
}
