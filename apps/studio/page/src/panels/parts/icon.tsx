// The icons of the page, all of one set (lucide, 1.5 px strokes), by the names that commands use.

import { h } from 'preact';
import {
  Box,
  Camera,
  Check,
  ChevronDown,
  ChevronRight,
  CircleAlert,
  CircleCheck,
  CircleDashed,
  CircleDot,
  CircleQuestionMark,
  Circle,
  CircleStop,
  ClockArrowLeft,
  Columns2,
  Download,
  Eye,
  EyeOff,
  FilePlus,
  FolderOpen,
  Ghost,
  GitCompare,
  Grid3x3,
  Info,
  Keyboard,
  Lasso,
  Layers2,
  Link,
  ListTree,
  Lock,
  LockOpen,
  Maximize,
  Menu,
  Merge,
  MirrorRectangular,
  Monitor,
  Moon,
  MousePointer2,
  Move,
  Move3d,
  PanelBottom,
  PanelLeft,
  PanelRight,
  Pause,
  PenLine,
  Pin,
  Play,
  Plus,
  Redo2,
  Rotate3d,
  RotateCcw,
  Ruler,
  Save,
  Scale3d,
  Scissors,
  Search,
  Settings2,
  Spline,
  Split,
  Square,
  SquareDashedMousePointer,
  Sun,
  Trash2,
  TriangleAlert,
  Undo2,
  WavesHorizontal,
  Wrench,
  X,
  type IconNode,
} from 'lucide';

const icons = {
  box: Box,
  camera: Camera,
  check: Check,
  close: X,
  collapse: ChevronDown,
  compare: GitCompare,
  dark: Moon,
  delete: Trash2,
  down: ChevronDown,
  export: Download,
  eye: Eye,
  'eye-off': EyeOff,
  fit: Maximize,
  ghost: Ghost,
  grid: Grid3x3,
  help: CircleQuestionMark,
  history: ClockArrowLeft,
  hole: CircleDashed,
  info: Info,
  insert: CircleDot,
  keyboard: Keyboard,
  lasso: Lasso,
  layers: Layers2,
  light: Sun,
  link: Link,
  lock: Lock,
  marquee: SquareDashedMousePointer,
  menu: Menu,
  merge: Merge,
  mirror: MirrorRectangular,
  modes: WavesHorizontal,
  move: Move,
  'move-3d': Move3d,
  new: FilePlus,
  open: FolderOpen,
  'panel-bottom': PanelBottom,
  'panel-left': PanelLeft,
  'panel-right': PanelRight,
  pause: Pause,
  pen: PenLine,
  pin: Pin,
  plan: Square,
  play: Play,
  plus: Plus,
  ready: CircleCheck,
  redo: Redo2,
  reset: RotateCcw,
  right: ChevronRight,
  rotate: Rotate3d,
  ruler: Ruler,
  save: Save,
  scale: Scale3d,
  search: Search,
  select: MousePointer2,
  settings: Settings2,
  'side-by-side': Columns2,
  split: Split,
  cut: Scissors,
  ring: Circle,
  rod: Spline,
  stop: CircleStop,
  system: Monitor,
  tree: ListTree,
  trouble: CircleAlert,
  undo: Undo2,
  unlock: LockOpen,
  warning: TriangleAlert,
  wrench: Wrench,
} satisfies Record<string, IconNode>;

export type IconName = keyof typeof icons;

export function isIconName(name: string | undefined): name is IconName {
  return name !== undefined && name in icons;
}

/** Never alone: the control around it has a name. */
export function Icon({ name }: { name: IconName }) {
  const parts: IconNode = icons[name];
  return (
    <svg
      class="icon"
      viewBox="0 0 24 24"
      fill="none"
      stroke="currentColor"
      stroke-width="1.5"
      stroke-linecap="round"
      stroke-linejoin="round"
      aria-hidden="true"
    >
      {parts.map(([tag, attributes]) => h(tag, attributes))}
    </svg>
  );
}
