// The pointer over the plan: shifts and zooms it, hovers, and hands everything else to the active tool.

import { effect } from '@preact/signals-core';
import type { Screen } from '../core/camera';
import { panPlan, toPlan, zoomPlan } from '../core/plan_camera';
import { pickPlan } from '../core/plan_picking';
import { joinOf } from '../core/selection';
import { snap } from '../core/snapping';
import * as store from '../core/store';
import type { Vec2 } from '../core/vec';
import { toolOf } from '../tools/index';
import type { PlanPointer, Tool } from '../tools/tool';

const kSnapPixels = 9;
const kPointPixels = 9;
const kRodPixels = 7;

/** Listens on an element over the plan; the function that it returns ends it. */
export function listenPlan(element: HTMLElement, size: () => Screen): () => void {
  const end = new AbortController();
  const options = { signal: end.signal };
  let panning = false;
  let pressed = false;
  let last: Vec2 = [0, 0];

  const pixel = (event: MouseEvent): Vec2 => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };

  const pointer = (event: MouseEvent, tool: Tool): PlanPointer => {
    const camera = store.planCamera.peek();
    const pixel_mm = 1 / camera.pixels_per_mm;
    const at = toPlan(camera, size(), pixel(event));
    const plan = store.plan.peek();
    const found = snap(
      {
        at,
        options: store.snapping.peek(),
        grid_mm: store.gridStep.peek(),
        reach_mm: kSnapPixels * pixel_mm,
        from: tool.from?.(),
        except: tool.except?.(),
        suspended: event.altKey,
      },
      plan,
    );
    const filter = store.selectionFilter.peek();
    const hit = plan && pickPlan(plan, at, kPointPixels * pixel_mm, kRodPixels * pixel_mm, filter, store.localMoves.peek());
    return { at, snap: found, hit, join: joinOf(event), pressed, pixel_mm, time: event.timeStamp };
  };

  element.addEventListener('pointerdown', (event) => {
    element.setPointerCapture(event.pointerId);
    last = pixel(event);
    // The left button belongs to the tool; the others shift the plan.
    panning = event.button !== 0;
    if (panning) return;
    pressed = true;
    const tool = toolOf(store.activeTool.peek());
    tool.down?.(pointer(event, tool));
  }, options);

  element.addEventListener('pointermove', (event) => {
    const now = pixel(event);
    if (panning) {
      store.planCamera.value = panPlan(store.planCamera.peek(), now[0] - last[0], now[1] - last[1]);
    } else {
      const tool = toolOf(store.activeTool.peek());
      const at = pointer(event, tool);
      if (!pressed) hover(at);
      tool.move?.(at);
    }
    last = now;
  }, options);

  element.addEventListener('pointerup', (event) => {
    if (!panning && pressed) {
      const tool = toolOf(store.activeTool.peek());
      const at = pointer(event, tool);
      pressed = false;
      tool.up?.(at);
    }
    panning = pressed = false;
  }, options);

  element.addEventListener('pointercancel', () => {
    panning = pressed = false;
    toolOf(store.activeTool.peek()).stop?.();
  }, options);
  element.addEventListener('pointerleave', () => {
    if (!pressed) store.hover.value = null;
  }, options);
  element.addEventListener('dblclick', (event) => {
    const tool = toolOf(store.activeTool.peek());
    tool.double?.(pointer(event, tool));
  }, options);
  for (const native of ['contextmenu', 'dragstart']) element.addEventListener(native, (event) => event.preventDefault(), options);
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    const camera = store.planCamera.peek();
    const size_ = event.deltaMode === 1 ? 18 : 1;
    if (store.navigation.peek() === 'trackpad' && !event.ctrlKey) {
      store.planCamera.value = panPlan(camera, -event.deltaX * size_, -event.deltaY * size_);
      return;
    }
    const factor = Math.exp(-event.deltaY * size_ * (event.ctrlKey && Math.abs(event.deltaY) < 30 ? 0.01 : 0.0016));
    store.planCamera.value = zoomPlan(camera, size(), pixel(event), factor);
  }, { passive: false, signal: end.signal });

  // The tool that was active gives up what it had under way.
  let active = toolOf(store.activeTool.peek());
  active.start?.();
  const follow = effect(() => {
    const now = toolOf(store.activeTool.value);
    if (now === active) return;
    active.stop?.();
    active = now;
    now.start?.();
    element.classList.toggle('crosshair', now.draws === true);
  });
  // A drag that the engine does not hear of any more is given up.
  const lost = effect(() => {
    if (store.connection.value === 'lost') toolOf(store.activeTool.peek()).stop?.();
  });
  return () => {
    follow();
    lost();
    end.abort();
  };
}

function hover({ hit }: PlanPointer): void {
  const before = store.hover.peek();
  if (before?.kind === hit?.kind && before?.name === hit?.name) return;
  store.hover.value = hit ? { kind: hit.kind, name: hit.name, index: hit.index, text: `${hit.kind} ${hit.name}` } : null;
}
