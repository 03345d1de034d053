// A stand-in for the engine while the page is developed without one: a disc with two crossing rods whose saddle follows
// the plan. It answers the requests that the page cannot do without; the built page knows nothing of it.

import type { Server } from 'node:http';
import { WebSocketServer, type WebSocket } from 'ws';
import { encodePack } from '../src/core/packs';
import type { Edit, PlanEvent, Request } from '../src/core/protocol';
import { discMesh, planOf, saddle, type Disc } from './disc';

export function attach(http: Server): void {
  const sockets = new WebSocketServer({ noServer: true });
  http.on('upgrade', (request, socket, head) => {
    if (request.url?.startsWith('/live')) sockets.handleUpgrade(request, socket, head, (wire) => serve(wire));
  });
}

const fieldRods = { name: 'axial strain', unit: '%', low: -0.05, high: 0.02, diverging: true };
const fieldFabric = { name: 'smallest stretch', unit: '', low: 1.06, high: 1.38, diverging: false };

function serve(wire: WebSocket): void {
  let points = new Map<string, [number, number]>([['c', [0, 0]]]);
  for (let k = 0; k < 8; ++k) points.set(`p${k}`, [90 * Math.cos((k * Math.PI) / 4), 90 * Math.sin((k * Math.PI) / 4)]);
  let revision = 1;
  let sequence = 0;
  let disc: Disc = discMesh();
  const say = (event: object) => wire.send(JSON.stringify(event));
  const shape = (places: Map<string, [number, number]>, drag: number, kind = 'shape', height?: number) => {
    const { positions, normals, edgeValues, triangleValues } = saddle(disc, places, height);
    const header = { pack: kind, sequence: ++sequence, topology: 1, residual_n: 3e-7, settled: true, drag, plan_revision: revision, field_rods: fieldRods, field_fabric: fieldFabric };
    wire.send(
      encodePack(header, [
        { name: 'positions', data: positions, columns: 3 },
        { name: 'normals', data: normals, columns: 3 },
        { name: 'edge_values', data: edgeValues },
        { name: 'triangle_values', data: triangleValues },
      ]),
    );
  };
  const plan = (places: Map<string, [number, number]>) => say(planOf(places, revision) satisfies PlanEvent);
  const everything = () => {
    say({ event: 'project', name: 'disc', file: '', title: 'Disc', saved: true, kind: 'plan' });
    plan(points);
    say({ event: 'history', steps: [], at: 0, saved_at: 0 });
    const header = { pack: 'topology', sequence: ++sequence, topology: 1, plan_revision: revision, rods: disc.rods, field_rods: fieldRods.name, field_fabric: fieldFabric.name };
    wire.send(encodePack(header, disc.arrays));
    shape(points, 0, 'flat', 0);
    shape(points, 0);
    say({ event: 'verdict', name: 'stable', sentence: 'settled: every small motion costs energy', settled: true, residual_n: 3e-7, iterations: 2, factorizations: 3, milliseconds: 62, lowest_mode_n_per_m: 0.8, negative_modes: 0, energy_mj: 12, shown: 'settled', note: '', worst: [] });
  };
  const moved = (edit: Edit) => {
    const places = new Map(points);
    if (edit.name === 'move_points') for (const { point, to_mm } of edit.moves) places.set(point, to_mm);
    return places;
  };
  wire.on('message', (data) => {
    const request = JSON.parse(String(data)) as Request & { id: number };
    const answer: Record<string, unknown> = { id: request.id, ok: true };
    if (request.do === 'hello') {
      Object.assign(answer, { version: 'stand-in', name: 'lissom', folder: '.', edits: [], fields: { rods: [{ ...fieldRods, sentence: '' }], fabric: [{ ...fieldFabric, sentence: '' }] }, templates: [{ name: 'disc', title: 'Disc', sentence: 'A ring.' }], materials: { rods: ['PLA'], fabric: ['knit'] } });
      say(answer);
      everything();
      return;
    }
    if (request.do === 'files') Object.assign(answer, { files: [], recent: [], designs: [] });
    if (request.do === 'handle_begin') Object.assign(answer, { center_mm: [60, 20, 12], weights: 30, parameters: 20 });
    say(answer);
    if (request.do === 'drag') {
      ++revision;
      plan(moved(request.edit));
      shape(moved(request.edit), request.drag);
    } else if (request.do === 'drag_end' || request.do === 'edit') {
      points = moved(request.edit);
      ++revision;
      plan(points);
      shape(points, 0);
      say({ event: 'history', steps: [{ title: 'Move', seconds: 0.1 }], at: 1, saved_at: 0 });
    }
  });
}
