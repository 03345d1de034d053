// How the parts of the page lie, where the store does not say it.

import { signal } from '@preact/signals';

/** Share of the middle that the plan takes where it is not alone. */
export const planShare = signal(0.36);

/** Somebody has dragged a point in this browser before: the first line of help can go. */
export const beganBefore = signal(false);
