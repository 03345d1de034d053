// Everything that the page knows, as signals. Panels read `.value` and re-render by themselves; the view subscribes with
// `effect`. What comes from the engine is written by core/apply.ts only; panels and tools write only the signals under
// "The page's own". To change the design, send requests (core/connection.ts: send, edit), never write the plan.

import { computed, signal } from '@preact/signals-core';
import type {
  BranchesEvent,
  BranchesPack,
  EngineFault,
  FitEvent,
  HandleEvent,
  Hello,
  HistoryEvent,
  JobEvent,
  JobName,
  MeasuresEvent,
  ModesEvent,
  ModesPack,
  PlanEvent,
  PreviewPack,
  ProjectEvent,
  ShapePack,
  TopologyPack,
  VerdictEvent,
  Warning,
} from './protocol';
import { homeCamera, type Camera, type Screen } from './camera';
import { emptySelection, type Hover, type Selection } from './selection';

// ---- From the engine (null until it has spoken) ------------------------------------------------------------------------

/** "connecting" at first, "open" after hello was answered, "lost" while trying again. */
export type ConnectionState = 'connecting' | 'open' | 'lost';
export const connection = signal<ConnectionState>('connecting');
/** Answer to hello: version, folder, edits, fields, templates, materials. */
export const hello = signal<Hello | null>(null);
export const project = signal<ProjectEvent | null>(null);
/** While something is dragged it follows at most five times a second (as do verdict, measures and warnings); pictures of
 *  the plan use livePlan. */
export const plan = signal<PlanEvent | null>(null);
/** The plan at every step of a drag: for what draws it, not for panels. */
export const livePlan = signal<PlanEvent | null>(null);
export const history = signal<HistoryEvent | null>(null);
export const verdict = signal<VerdictEvent | null>(null);
export const measures = signal<MeasuresEvent | null>(null);
export const warnings = signal<Warning[]>([]);
/** The last word of each job; a job that runs has state "running". */
export const jobs = signal<Partial<Record<JobName, JobEvent>>>({});
export const modes = signal<ModesEvent | null>(null);
export const handle = signal<HandleEvent | null>(null);
export const fit = signal<FitEvent | null>(null);
export const branches = signal<BranchesEvent | null>(null);
/** The newest lines of the engine's log, at most 200. */
export const log = signal<string[]>([]);
/** What went wrong last, by a request or on its own; null after it was dismissed. Panels show it and set it to null. */
export const fault = signal<EngineFault | null>(null);

/** Counts the designs that were opened: views show each whole. A file that is saved under another name is the same. */
export const design = signal(0);

/** Packs. `shape` changes up to 60 times a second: never read its `.value` while rendering a panel; use `effect`, or the
 *  events above, which carry the numbers that people read. */
export const topology = signal<TopologyPack | null>(null);
export const shape = signal<ShapePack | null>(null);
/** Mesh and shape that belong together. Between a new mesh and its first shape it is still the old pair, which is what is
 *  on the screen: pictures and picking use this. */
export const picture = signal<{ topology: TopologyPack; shape: ShapePack } | null>(null);
/** The newest shape that was settled. */
export const settledShape = signal<ShapePack | null>(null);
export const settledMesh = signal<TopologyPack | null>(null);
/** The plan itself as a shape, for the overlay "flat". */
export const flatShape = signal<ShapePack | null>(null);
/** The shape before the last step of history, for the overlay "previous". */
export const previousShape = signal<ShapePack | null>(null);
/** Its mesh, which may be another one than now. */
export const previousMesh = signal<TopologyPack | null>(null);
/** Linear answer to the handle; null when no handle is held. `changes`, `rms_mm`, `residual_n`, `stale` are for panels. */
export const preview = signal<PreviewPack | null>(null);
export const modeShapes = signal<ModesPack | null>(null);
export const branchShapes = signal<BranchesPack | null>(null);

// ---- The page's own: work ----------------------------------------------------------------------------------------------

export type WorkMode = 'draw' | 'explore' | 'shape' | 'make';
/** Draw, Explore, Shape, Make: changes tools and inspector, never view or selection. Set by the commands "mode.*". */
export const workMode = signal<WorkMode>('draw');
/** id of the active tool (src/tools/index.ts): "select", "rod", "insert", "split", ... Set by the commands "tool.*". */
export const activeTool = signal('select');
/** One line about what the active tool waits for ("Click the next point, Enter ends the rod"); empty when idle. */
export const toolHint = signal('');
/** What is selected: control points and rods by name, mesh nodes by number. See core/selection.ts for its operations. */
export const selection = signal<Selection>(emptySelection);
/** What the pointer is on, in whichever view or panel; tree rows set it too. */
export const hover = signal<Hover | null>(null);
/** What a click, box or lasso in a view may pick. */
export type SelectionFilter = { points: boolean; rods: boolean; nodes: boolean };
export const selectionFilter = signal<SelectionFilter>({ points: true, rods: true, nodes: false });
/** Named sets of selections. */
export const namedSets = signal<Record<string, Selection>>({});
/** True: edits are followed by the equilibrium at once (requests hold, run). */
export const running = signal(true);
/** Number of the drag under way, 0 when there is none. Panels' sliders get their own with core/drag.ts. */
export const dragging = signal(0);

// ---- The page's own: Explore and Shape ---------------------------------------------------------------------------------

/** Which mode is drawn as a breathing ghost; -1: none. */
export const shownMode = signal(-1);
/** Amplitude of the shown mode, mm (both signs). */
export const modeAmplitude = signal(10);
/** The ghost breathes between -amplitude and +amplitude; false: it stands at the amplitude. */
export const modeBreathes = signal(true);
/** Which other stable shape is drawn as a ghost; -1: none. */
export const shownBranch = signal(-1);
/** What is to stay where it is while something else is pulled. */
export const still = signal<Selection>(emptySelection);
/** Soft radius of the handle, mm. The wheel over the view changes it in Shape. */
export const softRadius = signal(20);
/** What the gizmo does. */
export type GizmoKind = 'move' | 'rotate' | 'scale';
export const gizmoKind = signal<GizmoKind>('move');
/** Middle of what is held, as the engine answered; null: nothing is held. The gizmo stands there. */
export const handleCenter = signal<[number, number, number] | null>(null);
/** The wanted place since handle_begin, as sent last; panels may show numbers and write them through core/handles.ts. */
export const handlePose = signal<{ move_mm: [number, number, number]; turn_deg: [number, number, number]; scale: number }>({
  move_mm: [0, 0, 0],
  turn_deg: [0, 0, 0],
  scale: 1,
});

// ---- The page's own: look ----------------------------------------------------------------------------------------------

export type Theme = 'light' | 'dark' | 'system';
export const theme = signal<Theme>('system');
/** True when the operating system asks for dark; written by main.tsx. */
export const systemDark = signal(false);
/** True when the operating system asks for reduced motion; written by main.tsx. */
export const reducedMotion = signal(false);
export const dark = computed(() => theme.value === 'dark' || (theme.value === 'system' && systemDark.value));
/** 1 to 2. */
export const uiScale = signal(1);

export type NavigationPreset = 'rhino' | 'blender' | 'cad' | 'trackpad';
export const navigation = signal<NavigationPreset>('rhino');
export type NamedView = 'top' | 'bottom' | 'front' | 'back' | 'left' | 'right' | 'home';
/** Parallel projection; the camera follows. */
export const orthographic = signal(false);
/** The camera of the 3D view and the size of its picture in CSS pixels. Commands "view.*" and the view write them. */
export const camera = signal<Camera>(homeCamera);
export const viewSize = signal<Screen>({ width: 0, height: 0 });
/** What the plan shows: the place in the middle, mm, and CSS pixels per mm. */
export const planCamera = signal<{ center_mm: [number, number]; pixels_per_mm: number }>({ center_mm: [0, 0], pixels_per_mm: 2 });
/** Where the running drag wants points to be, mm; drawn at once, before the engine has answered. */
export const localMoves = signal<ReadonlyMap<string, [number, number]>>(new Map());

/** What is drawn in 3D. */
export const show = {
  fabric: signal(true),
  rods: signal(true),
  ghosts: signal(true),
  constraints: signal(true),
  grid: signal(true),
  flat: signal(false),
  previous: signal(false),
  target: signal(true),
  preview: signal(true),
  /** Fabric as lines, for looking at the mesh. */
  mesh: signal(false),
  points: signal(true),
};

/** Which values colour rods and fabric; the empty name: none, plain material. Set by setFields of core/fields.ts. */
export const rodField = signal('');
export const fabricField = signal('');
/** Range of a legend: locked ones stay as they are, others follow what the shape says (its symmetric hull when the field
 *  is diverging). Written by core/fields.ts on each shape, and by panels (low, high, locked). */
export interface LegendRange {
  low: number;
  high: number;
  locked: boolean;
}
export const rodRange = signal<LegendRange>({ low: -1, high: 1, locked: false });
export const fabricRange = signal<LegendRange>({ low: 1, high: 2, locked: false });

/** Where the plan stands: below the 3D view, beside it, alone, or not at all. */
export type PlanDock = 'below' | 'beside' | 'full' | 'hidden';
export const planDock = signal<PlanDock>('below');
export const treeOpen = signal(true);
export const inspectorOpen = signal(true);

/** "auto": low on software renderers. low: no antialiasing, six sides, pixel ratio 1. */
export type Quality = 'auto' | 'high' | 'low';
export const quality = signal<Quality>('auto');
/** Name of what draws, for the about box; "" until the view has started. */
export const rendererName = signal('');
export const softwareRenderer = signal(false);

/** Snapping in the plan; Alt suspends it. */
export const snapping = signal({ grid: true, points: true, rods: true, angle: true, symmetry: true });
export const gridStep = signal(5);

/** Sentence for the live region (polite); written by announce() of core/commands.ts and by verdict changes. */
export const announcement = signal('');

/** Which overlay panel is open; panels own its meaning. */
export type Dialog = '' | 'commands' | 'keys' | 'start' | 'save' | 'export' | 'about' | 'settings' | 'verdict' | 'history';
export const dialog = signal<Dialog>('');

// ---- Derived -----------------------------------------------------------------------------------------------------------

export const canUndo = computed(() => (history.value?.at ?? 0) > 0);
export const canRedo = computed(() => (history.value?.at ?? 0) < (history.value?.steps.length ?? 0));
/** Points of the plan by name: index into plan.points. */
export const pointIndex = computed(() => new Map((plan.value?.points ?? []).map((p, i) => [p.name, i])));
export const rodIndex = computed(() => new Map((plan.value?.rods ?? []).map((r, i) => [r.name, i])));
/** True while nothing may be edited: no connection, or a structure that is only looked at. */
export const lookOnly = computed(() => connection.value !== 'open' || project.value?.kind === 'structure');
