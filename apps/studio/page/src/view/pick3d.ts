// What lies under the pointer in the 3D view, and what a box or lasso takes. Places on the screen are computed once for
// each camera and shape.

import { Projector, type Camera, type Screen } from '../core/camera';
import { firstTriangle, forEachEdge, nearestPoint, nearestSegment } from '../core/picking';
import { kNoNode, type ShapePack, type TopologyPack } from '../core/protocol';
import type { Region } from '../core/regions';
import { makeSelection, type Hover, type Selection } from '../core/selection';
import * as store from '../core/store';
import { row3, type Vec2, type Vec3 } from '../core/vec';

const kPointReach = 9;
const kRodReach = 7;

export interface Hit {
  hover: Hover;
  /** What a click selects; nothing for bare fabric. */
  selection: Selection;
  at: Vec3;
  /** Nearest node of the mesh. */
  node: number;
}

interface Scene {
  topology: TopologyPack;
  shape: ShapePack;
  projector: Projector;
  screen: Float32Array;
}

let cached: { camera: Camera; size: Screen; shape: ShapePack; scene: Scene } | null = null;

export function scene(): Scene | null {
  const picture = store.picture.peek();
  const camera = store.camera.peek();
  const size = store.viewSize.peek();
  if (!picture) return null;
  const { topology, shape } = picture;
  if (!cached || cached.camera !== camera || cached.shape !== shape || cached.size !== size) {
    const projector = new Projector(camera, size);
    cached = { camera, size, shape, scene: { topology, shape, projector, screen: projector.all(shape.positions) } };
  }
  return cached.scene;
}

/** `nodes`: what is meant are nodes of the mesh (Shape), not rods. */
export function pick(at: Vec2, nodes: boolean): Hit | null {
  const now = scene();
  if (!now) return null;
  return pickPoint(now, at) ?? (nodes ? pickNode(now, at) : pickRod(now, at)) ?? pickFabric(now, at);
}

function pickPoint({ topology, shape, screen }: Scene, at: Vec2): Hit | null {
  if (!store.selectionFilter.peek().points || !store.show.points.peek()) return null;
  const node = nearestPoint(screen, [...topology.point_nodes].filter((n) => n !== kNoNode), at, kPointReach);
  if (node < 0) return null;
  const index = topology.point_nodes.indexOf(node);
  const name = store.plan.peek()?.points[index]?.name;
  if (name === undefined) return null;
  return {
    hover: { kind: 'point', name, index, text: `point ${name}` },
    selection: makeSelection({ points: [name] }),
    at: row3(shape.positions, node),
    node,
  };
}

function pickRod({ topology, shape, screen }: Scene, at: Vec2): Hit | null {
  if (!store.selectionFilter.peek().rods || !store.show.rods.peek()) return null;
  const hit = nearestSegment(screen, topology, at, kRodReach);
  if (!hit) return null;
  const name = topology.rods[hit.chain].plan_rod;
  const node = hit.nodes[hit.t < 0.5 ? 0 : 1];
  const { field_rods: field, edge_values: values } = shape;
  const value = store.rodField.peek() !== '' && values.length > hit.edge ? `, ${valueText(field.name, values[hit.edge], field.unit)}` : '';
  return {
    hover: { kind: 'rod', name, index: hit.edge, text: `rod ${name}${value}` },
    selection: makeSelection({ rods: [name] }),
    at: row3(shape.positions, node),
    node,
  };
}

/** Nearest node of a rod, or of the fabric under the pointer. */
function pickNode(now: Scene, at: Vec2): Hit | null {
  const rod = nearestSegment(now.screen, now.topology, at, kRodReach);
  const node = rod ? rod.nodes[rod.t < 0.5 ? 0 : 1] : (pickFabric(now, at)?.node ?? -1);
  if (node < 0) return null;
  return {
    hover: { kind: 'node', name: '', index: node, text: `node ${node}` },
    selection: makeSelection({ nodes: [node] }),
    at: row3(now.shape.positions, node),
    node,
  };
}

function pickFabric({ topology, shape, projector, screen }: Scene, at: Vec2): Hit | null {
  if (!store.show.fabric.peek()) return null;
  const hit = firstTriangle(shape.positions, topology.triangles, projector.ray(at));
  if (!hit) return null;
  const corners = topology.triangles.subarray(3 * hit.triangle, 3 * hit.triangle + 3);
  const { field_fabric: field, triangle_values: values } = shape;
  const value = store.fabricField.peek() !== '' && values.length > hit.triangle ? valueText(field.name, values[hit.triangle], field.unit) : '';
  return {
    hover: { kind: 'triangle', name: '', index: hit.triangle, text: value },
    selection: makeSelection({}),
    at: hit.at,
    node: nearestPoint(screen, corners, at, Infinity),
  };
}

function valueText(name: string, value: number, unit: string): string {
  return `${name} ${Number(value.toPrecision(3))}${unit === '' || unit === '1' ? '' : ` ${unit}`}`;
}

/** What a region of the screen takes, by the filter; nodes only where they are meant. */
export function pickRegion(region: Region, nodes: boolean): Selection {
  const now = scene();
  if (!now) return makeSelection({});
  const { topology, screen } = now;
  const pixel = (node: number): Vec2 => [screen[3 * node], screen[3 * node + 1]];
  const filter = store.selectionFilter.peek();
  const plan = store.plan.peek();
  const inside = (node: number) => node !== kNoNode && screen[3 * node + 2] <= 1 && region.point(pixel(node));
  if (nodes || filter.nodes) {
    const taken = new Set<number>();
    forEachEdge(topology, (_chain, _edge, a, b) => [a, b].forEach((node) => inside(node) && taken.add(node)));
    for (const node of topology.triangles) if (inside(node)) taken.add(node);
    return makeSelection({ nodes: taken });
  }
  const points = filter.points ? (plan?.points ?? []).filter((_, i) => inside(topology.point_nodes[i])).map((p) => p.name) : [];
  const rods = new Map<string, boolean>();
  topology.rods.forEach((rod, r) => {
    const line = Array.from(topology.rod_nodes.subarray(topology.rod_starts[r], topology.rod_starts[r + 1]), pixel);
    const taken = filter.rods && region.line(line);
    // A rod of the plan may be several of the mesh: inside only when all of them are.
    rods.set(rod.plan_rod, taken && (rods.get(rod.plan_rod) ?? true));
  });
  return makeSelection({ points, rods: [...rods].filter(([, taken]) => taken).map(([name]) => name) });
}
