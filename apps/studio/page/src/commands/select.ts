// Commands of the selection.

import type { Command } from '../core/commands';
import { cancelHandle } from '../core/handles';
import { everything, grown, inverted, shrunk } from '../core/growth';
import { emptySelection, isEmpty, type Selection } from '../core/selection';
import type { PlanEvent, TopologyPack } from '../core/protocol';
import * as store from '../core/store';

function changing(make: (now: Selection, plan: PlanEvent, topology: TopologyPack | null) => Selection): Pick<Command, 'enabled' | 'run'> {
  return {
    enabled: () => store.plan.value !== null,
    run: () => {
      const plan = store.plan.peek();
      if (plan) store.selection.value = make(store.selection.peek(), plan, store.topology.peek());
    },
  };
}

function filter(kind: 'points' | 'rods' | 'nodes', title: string): Command {
  return {
    id: `select.filter_${kind}`,
    title,
    group: 'Select',
    checked: () => store.selectionFilter.value[kind],
    run: () => (store.selectionFilter.value = { ...store.selectionFilter.peek(), [kind]: !store.selectionFilter.peek()[kind] }),
  };
}

export const selectCommands: Command[] = [
  { id: 'select.all', title: 'Select all', group: 'Select', keys: ['Ctrl+A'], ...changing((_now, plan) => everything(plan)) },
  {
    id: 'select.none',
    title: 'Back to selecting, then select nothing',
    group: 'Select',
    keys: ['Escape'],
    enabled: () => store.activeTool.value !== 'select' || !isEmpty(store.selection.value) || store.handleCenter.value !== null,
    run: () => {
      if (store.activeTool.peek() !== 'select') store.activeTool.value = 'select';
      else if (store.handleCenter.peek()) cancelHandle();
      else store.selection.value = emptySelection;
    },
  },
  { id: 'select.invert', title: 'Invert the selection', group: 'Select', keys: ['Ctrl+I'], ...changing(inverted) },
  { id: 'select.grow', title: 'Grow the selection along rods', group: 'Select', keys: ['Plus', '='], icon: 'plus', ...changing(grown) },
  { id: 'select.shrink', title: 'Shrink the selection along rods', group: 'Select', keys: ['-'], ...changing(shrunk) },
  filter('points', 'Pick control points'),
  filter('rods', 'Pick rods'),
  filter('nodes', 'Pick nodes of the mesh'),
];
