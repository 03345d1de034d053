// One row of the tree.

import { hover, plan } from '../../core/store';
import type { Row, RowKind } from '../logic/tree_rows';
import { Icon, type IconName } from '../parts/icon';

const icons: Readonly<Partial<Record<RowKind, IconName>>> = {
  fabric: 'grid',
  hole: 'hole',
  rod: 'rod',
  point: 'insert',
  pin: 'pin',
  link: 'link',
  plane: 'plan',
  symmetry: 'mirror',
  shape: 'box',
  set: 'layers',
};

interface TreeRowProps {
  row: Row;
  selected: boolean;
  /** The one row that Tab leads to. */
  reachable: boolean;
  onOpen: (on: boolean) => void;
  onTake: (event: MouseEvent) => void;
}

export function TreeRow({ row, selected, reachable, onOpen, onTake }: TreeRowProps) {
  const icon = icons[row.kind];
  return (
    <li
      class="tree-row"
      role="treeitem"
      data-key={row.key}
      data-level={row.level}
      data-point={row.kind === 'point' || row.kind === 'pin' ? row.title : undefined}
      aria-level={row.level}
      aria-posinset={row.place}
      aria-setsize={row.siblings}
      aria-expanded={row.open}
      aria-selected={selected}
      tabIndex={reachable ? 0 : -1}
      onClick={onTake}
      onDblClick={() => {
        if (row.open !== undefined) onOpen(!row.open);
      }}
      onPointerEnter={() => setHover(row)}
      onPointerLeave={() => (hover.value = null)}
    >
      <span
        class="tree-twist"
        onClick={(event) => {
          if (row.open === undefined) return;
          event.stopPropagation();
          onOpen(!row.open);
        }}
      >
        {row.open !== undefined && <Icon name={row.open ? 'down' : 'right'} />}
      </span>
      {icon && <Icon name={icon} />}
      <span class="tree-title">{row.title}</span>
      <span class="tree-detail small soft">{row.detail}</span>
    </li>
  );
}

function setHover(row: Row): void {
  if (row.rods.length === 1) hover.value = { kind: 'rod', name: row.rods[0], index: plan.peek()?.rods.findIndex((r) => r.name === row.rods[0]) ?? -1 };
  else if (row.points.length === 1) {
    const name = row.points[0];
    hover.value = { kind: 'point', name, index: plan.peek()?.points.findIndex((p) => p.name === name) ?? -1 };
  }
}
