// @vitest-environment jsdom
import { fireEvent, screen } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { choose, click, openPage, type Page } from './page';
import type { Job } from '../../src/api/types';
import { MapChoice, MapLegend } from '../../src/scene/MapLegend';
import { SceneHands, type Ray } from '../../src/scene/SceneHands';
import { ScenePane } from '../../src/scene/ScenePane';
import { ready, type AppState } from '../../src/state/AppState';
import type { ClothPoint } from '../../src/state/hands';
import { sceneTools } from '../../src/tools/table';
import type { BoxPlace } from '../../src/tools/SceneTool';
import type { Place } from '../../src/api/dressing';
import { jobOf } from '../fakes';

let page: Page;
beforeEach(() => {
  page = openPage();
});

/** What lies under the pointer, as the test puts it there. */
class FakeRay implements Ray {
  pieceThere: string | null = null;
  landmarkThere: string | null = null;
  skinThere: Place | null = null;
  boxThere: BoxPlace | null = null;
  valueThere = NaN;
  clothThere: ClothPoint | null = null;
  besideThere: Place = [0, 0, 0];
  said: unknown[] = [];

  through = (): this => this;
  piece = (): string | null => this.pieceThere;
  landmark = (): string | null => this.landmarkThere;
  skin = (): Place | null => this.skinThere;
  mapValue = (): number => this.valueThere;
  box = (): BoxPlace | null => this.boxThere;
  cloth = (): ClothPoint | null => this.clothThere;
  beside = (): Place => this.besideThere;
  openBoxes = (open: boolean): void => void this.said.push(open ? 'boxes' : 'no boxes');
  moveLandmark = (name: string, to: Place): void => void this.said.push([name, to]);
}

describe('the hand in the 3D view', () => {
  /** Over a canvas, with the tools that this state gives it. */
  function take(how: (state: AppState) => void = () => undefined) {
    const canvas = document.createElement('canvas');
    const ray = new FakeRay();
    const controls = { enabled: true };
    const hands = new SceneHands(canvas, ray, controls, page, () => undefined);
    page.change(how);
    hands.setTools(sceneTools.filter((tool) => tool.isHeld(page.state)));
    const at = (x: number): object => ({ clientX: x, clientY: 0, button: 0, buttons: 1 });
    return {
      canvas,
      ray,
      controls,
      hands,
      down: () => fireEvent.pointerDown(canvas, at(0)),
      move: (x: number) => fireEvent.pointerMove(canvas, at(x)),
      up: (x: number) => fireEvent.pointerUp(canvas, { ...at(x), buttons: 0 }),
    };
  }
  it('reads the value of the map under it, and none beside the cloth', () => {
    const { canvas, ray } = take((state) => (state.clothMap.value = { kind: 'warp', values: new Float32Array(3), end: 1 }));
    ray.valueThere = 0.4;
    fireEvent.pointerMove(canvas, { pointerType: 'mouse', buttons: 0 });
    expect(page.state.pointedValue.value).toBe(0.4);
    fireEvent.pointerLeave(canvas);
    expect(page.state.pointedValue.value).toBeNaN();
  });

  const arranging = (state: AppState): void => void (state.tab.value = 'arrange');
  const marking = (state: AppState): void => {
    state.tab.value = 'body';
    state.dressing.marks.value = { tape: false, landmarks: true, boxes: false };
  };
  const front: BoxPlace = { part: 'torso', side: 'front', at_mm: [0, 30] };

  it('selects the piece that is clicked, and nothing beside it', () => {
    const { ray, down, up } = take();
    ray.pieceThere = 'a';
    down();
    up(2);
    ray.pieceThere = null;
    down();
    up(0);
    expect(page.asked()).toEqual([
      ['select', 'a'],
      ['select', null],
    ]);
  });

  it('leaves the view to the camera when it goes further', () => {
    const { ray, controls, down, move, up } = take();
    ray.pieceThere = 'a';
    down();
    move(50);
    expect(controls.enabled).toBe(true);
    up(50);
    expect(page.asked()).toEqual([]);
  });

  it('lights up the piece that it passes over, until it leaves', () => {
    const { canvas, ray } = take();
    ray.pieceThere = 'a';
    fireEvent.pointerMove(canvas, { buttons: 0 });
    fireEvent.pointerLeave(canvas);
    expect(page.asked()).toEqual([
      ['hover', 'a'],
      ['hover', null],
    ]);
  });

  it('drags a piece onto the side of a box, while pieces are arranged', () => {
    const { canvas, ray, controls, down, move, up } = take(arranging);
    ray.pieceThere = 'a';
    down();
    expect(controls.enabled).toBe(false);
    move(20);
    expect([canvas.style.cursor, ray.said]).toEqual(['not-allowed', ['boxes']]);
    ray.boxThere = front;
    move(40);
    expect(canvas.style.cursor).toBe('copy');
    up(40);
    expect([canvas.style.cursor, controls.enabled, ray.said]).toEqual(['', true, ['boxes', 'no boxes']]);
    expect(page.asked()).toEqual([
      ['hover', 'a'],
      ['hover', 'a'],
      ['dressing.drop', 'a', front],
    ]);
  });

  it('lets a piece be where it was when it is let go beside the boxes, or given up', () => {
    const { canvas, ray, controls, down, move, up } = take(arranging);
    ray.pieceThere = 'a';
    down();
    move(20);
    up(20);
    ray.boxThere = front;
    down();
    move(20);
    fireEvent.pointerCancel(canvas);
    up(20);
    expect(controls.enabled).toBe(true);
    expect(page.asked().filter(([command]) => command !== 'hover')).toEqual([]);
  });

  it('selects a piece that is pressed and not dragged', () => {
    const { ray, down, up } = take(arranging);
    ray.pieceThere = 'a';
    down();
    up(1);
    expect(page.asked()).toEqual([['select', 'a']]);
  });

  it('drags a landmark over the body; beside it, it stays where it was seen last', () => {
    const { canvas, ray, down, move, up } = take(marking);
    ray.landmarkThere = 'left_hip';
    ray.skinThere = [0, 1, 0.1];
    down();
    expect(canvas.style.cursor).toBe('grabbing');
    move(20);
    ray.skinThere = null;
    move(200);
    up(200);
    expect(ray.said).toEqual([['left_hip', [0, 1, 0.1]]]);
    expect(page.asked()).toEqual([['dressing.mark', 'left_hip', [0, 1, 0.1]]]);
  });

  it('does nothing with a landmark that is only clicked', () => {
    const { ray, down, up } = take(marking);
    ray.landmarkThere = 'left_hip';
    ray.pieceThere = 'a';
    down();
    up(0);
    expect(page.asked()).toEqual([]);
  });

  it('puts the landmark that was named where the body is clicked, and selects beside it', () => {
    const { canvas, ray, down, up } = take((state) => {
      marking(state);
      state.dressing.picking.value = 'belt';
    });
    expect(canvas.style.cursor).toBe('crosshair');
    ray.landmarkThere = 'left_hip';
    ray.skinThere = [0, 1, 0];
    down();
    up(0);
    ray.skinThere = null;
    down();
    up(0);
    expect(page.asked()).toEqual([
      ['dressing.mark', 'belt', [0, 1, 0]],
      ['select', null],
    ]);
  });

  const draping = (tool: 'pull' | 'pin') => (state: AppState): void => {
    state.jobs.value = ready([jobOf({ state: 'running' })]);
    state.stream.value = { state: 'open' };
    state.covered.value = true;
    state.tab.value = 'drape';
    state.hands.tool.value = tool;
  };
  const point: ClothPoint = { triangle: 4, shares: [1, 0, 0], at: [0, 1, 0] };

  it('pulls at cloth while it drapes, and turns the view beside it', () => {
    const { ray, controls, down, move, up } = take(draping('pull'));
    ray.clothThere = point;
    down();
    expect(controls.enabled).toBe(false);
    ray.besideThere = [0.2, 1.1, 0];
    move(30);
    up(30);
    expect(controls.enabled).toBe(true);
    expect(page.asked()).toEqual([['live.hold', point], ['live.draw', [0.2, 1.1, 0]], ['live.letGo']]);
    ray.clothThere = null;
    down();
    expect(controls.enabled).toBe(true);
    up(30);
    expect(page.asked()).toEqual([]);
  });

  it('pins the point that is clicked', () => {
    const { ray, down, move, up } = take(draping('pin'));
    ray.clothThere = point;
    down();
    up(1);
    down();
    move(40); // turns the view
    up(40);
    expect(page.asked()).toEqual([['live.pin', point]]);
  });

  it('lets go of what its tools may no longer hold', () => {
    const { ray, controls, hands, down, move, up } = take(arranging);
    ray.pieceThere = 'a';
    ray.boxThere = front;
    down();
    move(20);
    hands.setTools([]);
    expect(controls.enabled).toBe(true);
    up(20);
    expect(page.asked()).toEqual([['hover', 'a']]);
  });
});

describe('the 3D view without its picture', () => {
  const never = new Promise<never>(() => undefined);
  const drape = (more: Partial<Job>): void => page.change((state) => (state.jobs.value = ready([jobOf(more)])));
  const open = (code: Promise<never> = never): void => page.show(<ScenePane code={code} drawn={() => undefined} />);

  it('starts the first drape of a project', () => {
    open();
    expect(screen.getByRole('heading').textContent).toBe('Not draped yet');
    click(screen.getByRole('button', { name: 'Start drape Space' }));
    expect(page.asked()).toEqual([['startDrape']]);
  });

  it('tells the place in the queue', () => {
    const waiting = { state: 'queued' as const };
    page.change((state) => {
      state.route.value = { name: 'job', id: 'j_2' };
      state.jobs.value = ready([
        jobOf({ ...waiting, id: 'j_2', created_ms: 5 }),
        jobOf({ ...waiting, created_ms: 1 }),
      ]);
    });
    open();
    expect(screen.getByText('1 drape before it.')).toBeTruthy();
    drape({ ...waiting, id: 'j_2' });
    expect(screen.getByText(/It is next/)).toBeTruthy();
  });

  it('says what is done, and how it ended without cloth', () => {
    open();
    drape({ state: 'running' });
    expect(screen.getByRole('status').textContent).toBe('Starting…');
    drape({ state: 'failed', reason: 'the start crosses the body' });
    expect(screen.getByRole('heading').textContent).toBe('This drape failed');
    click(screen.getByRole('button', { name: 'Why' }));
    expect(page.state.tab.value).toBe('drape');
    expect(page.state.beforeDrape.value).toBe(true);
    drape({ state: 'cancelled' });
    expect(screen.getByRole('heading').textContent).toBe('Cancelled');
    drape({ state: 'succeeded' });
    expect(screen.queryByRole('heading')).toBeNull();
  });

  it('says that a change is under way', () => {
    page.change((state) => (state.dressing.busy.value = 'Making the body'));
    open();
    expect(screen.getByText('Making the body…')).toBeTruthy();
  });

  it('says that there is none where the browser has no WebGL', async () => {
    open(Promise.reject(new Error('no context')));
    expect(await screen.findByText('This browser could not open WebGL 2: no context')).toBeTruthy();
  });

  it('turns to a side, and shows or hides body and mesh', () => {
    open();
    for (const name of ['front view', 'three-quarter view', 'Body', 'Mesh']) {
      click(screen.getByRole('button', { name }));
    }
    expect(page.asked()).toEqual([
      ['showView', 'front'],
      ['showView', 'three-quarter'],
    ]);
    expect([page.state.bodyShown.value, page.state.meshShown.value]).toEqual([false, true]);
  });
});

describe('the map of the cloth', () => {
  const shown = (state: AppState): void => {
    state.jobs.value = ready([jobOf({ state: 'succeeded' })]);
    state.tab.value = 'result';
    state.covered.value = true;
  };

  it('is chosen over the cloth, not before there is any', () => {
    page.show(<MapChoice />);
    expect(screen.queryByRole('combobox')).toBeNull();
    page.change(shown);
    choose(screen.getByRole('combobox', { name: 'Colour the cloth by' }), 'room');
    expect(page.state.mapKind.value).toBe('room');
    choose(screen.getByRole('combobox', { name: 'Colour the cloth by' }), '');
    expect(page.state.mapKind.value).toBeNull();
  });

  it('has a legend with the ends of its bands, and the value that is pointed at', () => {
    page.change(shown);
    page.show(<MapLegend />);
    expect(screen.queryByRole('figure')).toBeNull();
    page.change((state) => (state.clothMap.value = { kind: 'warp', values: new Float32Array([0, 1.5]), end: 2 }));
    const legend = screen.getByRole('figure', { name: /^Stretch along the warp: Red is stretched/ });
    expect([...legend.querySelectorAll('li')].map((one) => one.textContent)).toEqual(
      ['−2', '−1.5', '−1', '−0.5', '0', '0.5', '1', '1.5', '2'],
    );
    page.change((state) => (state.pointedValue.value = 1.7));
    expect(legend.querySelector('b')!.textContent).toBe('1.7 %');
    expect([...legend.querySelectorAll('li')].findIndex((one) => one.className === 'lit')).toBe(7);
  });
});
