// Selects what a verdict or a warning points at, and brings it into view.

import { run } from '../core/commands';
import { makeSelection } from '../core/selection';
import { rodIndex, pointIndex, selection, topology } from '../core/store';
import { nodesOfEdge } from './logic/edges';

export interface Place {
  node?: number;
  edge?: number;
  triangle?: number;
  nodes?: readonly number[];
  rod?: string;
  point?: string;
}

/** Whether there is anything to select. */
export function isPlace(place: Place): boolean {
  const numbers = [place.node, place.edge, place.triangle].some((n) => n !== undefined && n >= 0);
  return numbers || (place.nodes?.length ?? 0) > 0 || place.rod !== undefined || place.point !== undefined;
}

export function selectPlace(place: Place): void {
  const mesh = topology.peek();
  const nodes = new Set(place.nodes ?? []);
  if (place.node !== undefined && place.node >= 0) nodes.add(place.node);
  if (mesh && place.triangle !== undefined && place.triangle >= 0) {
    for (let k = 0; k < 3; ++k) nodes.add(mesh.triangles[3 * place.triangle + k]);
  }
  let rod = place.rod;
  if (mesh && place.edge !== undefined && place.edge >= 0) {
    const found = nodesOfEdge(mesh, place.edge);
    found?.nodes.forEach((node) => nodes.add(node));
    if (found) rod ??= mesh.rods[found.rod]?.plan_rod;
  }
  selection.value = makeSelection({
    nodes,
    rods: rod !== undefined && rodIndex.peek().has(rod) ? [rod] : [],
    points: place.point !== undefined && pointIndex.peek().has(place.point) ? [place.point] : [],
  });
  run('view.fit_selection');
}
