// All that the plan's picture depends on, read once per picture; reading it in an effect follows every part.

import type { Screen } from '../core/camera';
import type { PlanCamera } from '../core/plan_camera';
import { toPixel } from '../core/plan_camera';
import type { PlanEvent, TopologyPack, Vec2 } from '../core/protocol';
import type { Hover, Selection } from '../core/selection';
import { planMarquee, sketch, type Sketch } from '../core/sketch';
import * as store from '../core/store';
import { paletteOf, type Palette } from './palette';

export interface PlanScene {
  plan: PlanEvent | null;
  topology: TopologyPack | null;
  camera: PlanCamera;
  size: Screen;
  selection: Selection;
  hover: Hover | null;
  moves: ReadonlyMap<string, Vec2>;
  sketch: Sketch;
  marquee: { corners: Vec2[]; touching: boolean } | null;
  palette: Palette;
  grid: boolean;
  gridStep: number;
  constraints: boolean;
  ghosts: boolean;
  points: boolean;
  pixel: (at: Vec2) => Vec2;
}

/** What the still layer shows: everything but what is dragged, hovered or selected. It is painted again only when its
 *  parts change, for curves and text are slow to paint without a graphics card. */
export function stillParts(scene: PlanScene): unknown[] {
  const { plan, topology, camera, size, palette, grid, gridStep, constraints, ghosts, points, moves } = scene;
  return [plan, topology, camera, size.width, size.height, palette, grid, gridStep, constraints, ghosts, points, [...moves.keys()].join(' ')];
}

export function planScene(size: Screen): PlanScene {
  const camera = store.planCamera.value;
  return {
    plan: store.livePlan.value,
    topology: store.topology.value,
    camera,
    size,
    selection: store.selection.value,
    hover: store.hover.value,
    moves: store.localMoves.value,
    sketch: sketch.value,
    marquee: planMarquee.value,
    palette: paletteOf(store.dark.value),
    grid: store.show.grid.value,
    gridStep: store.gridStep.value,
    constraints: store.show.constraints.value,
    ghosts: store.show.ghosts.value,
    points: store.show.points.value,
    pixel: (at) => toPixel(camera, size, at),
  };
}
