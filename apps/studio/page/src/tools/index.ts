// Tools of the plan and of the 3D view: one file each, one line each here, in the order of the toolbar.

import { attachTool, mergeTool } from './collect';
import { cutTool } from './cut';
import { eraseTool } from './erase';
import { ghostTool } from './ghost';
import { holeTool } from './hole';
import { insertTool } from './insert';
import { kinkTool } from './kink';
import { lassoTool } from './lasso';
import { mirrorTool } from './mirror';
import { pinTool } from './pin';
import { ringTool } from './ring';
import { ghostRodTool, rodTool } from './rod';
import { selectTool } from './select';
import type { Tool } from './tool';

export const tools: Tool[] = [
  selectTool,
  lassoTool,
  rodTool,
  ringTool,
  ghostRodTool,
  insertTool,
  cutTool,
  kinkTool,
  mergeTool,
  ghostTool,
  mirrorTool,
  eraseTool,
  holeTool,
  pinTool,
  attachTool,
];

export function toolOf(id: string): Tool {
  return tools.find((tool) => tool.id === id) ?? selectTool;
}
