// The verdict line of the present moment.

import { computed } from '@preact/signals';
import { connection, dragging, project, running, shape, verdict } from '../../core/store';
import { verdictLine } from '../logic/verdict_line';

/** Changes only when a shape comes to rest or leaves it, not with every iterate. */
const moving = computed(() => running.value && shape.value?.settled === false && verdict.value?.settled !== false);

export const presentLine = computed(() =>
  verdictLine({
    connection: connection.value,
    verdict: verdict.value,
    running: running.value,
    dragging: dragging.value !== 0,
    moving: moving.value,
    lookOnly: project.value?.kind === 'structure',
  }),
);
