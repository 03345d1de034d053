// Tools of the plan and of the 3D view: one file each, one line each here.

import type { Tool } from './tool';

export const tools: Tool[] = [];
