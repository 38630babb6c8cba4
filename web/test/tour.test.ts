// @vitest-environment jsdom
import { beforeEach, describe, expect, it } from 'vitest';
import { TourCommands } from '../src/commands/TourCommands';
import { AppState, ready } from '../src/state/AppState';
import { besides, tourStops } from '../src/state/tour';
import { projectOf } from './fakes';

const kWindow = { width: 1280, height: 800 };
const kCard = { width: 320, height: 200 };

describe('the card of the tour', () => {
  it('stands beside what it tells of where there is room, and always in the window', () => {
    const at = (left: number, top: number, width: number, height: number) => besides({ left, top, width, height }, kCard, kWindow);
    expect(at(240, 44, 500, 700)).toEqual({ left: 754, top: 44 });
    expect(at(880, 44, 400, 300)).toEqual({ left: 546, top: 44 });
    expect(at(0, 0, 1280, 44)).toEqual({ left: 946, top: 58 });
    expect(at(0, 760, 1280, 40)).toEqual({ left: 14, top: 546 });
    expect(at(0, 0, 1280, 800)).toEqual({ left: 14, top: 586 });
    expect(at(838, 7, 360, 30), 'below a bar').toEqual({ left: 878, top: 51 });
    expect(at(240, 770, 500, 30)).toEqual({ left: 240, top: 556 });
    // On a phone it is as broad as the window.
    expect(besides({ left: 0, top: 300, width: 390, height: 400 }, { width: 362, height: 200 }, { width: 390, height: 844 })).toEqual({
      left: 14,
      top: 86,
    });
  });
});

describe('the tour', () => {
  let state: AppState;
  let tours: TourCommands;
  beforeEach(() => {
    localStorage.clear();
    state = new AppState();
    tours = new TourCommands(state);
    state.jobs.value = ready([]);
  });
  const openProject = (): void => {
    state.projects.value = ready([projectOf()]);
    state.route.value = { name: 'project', id: 'p_1' };
  };

  it('begins by itself once, where a project is open, also if it is left at once', () => {
    tours.greet();
    expect(state.tourStop.value).toBeNull();
    openProject();
    tours.greet();
    expect(state.tourStop.value).toBe(0);
    expect(tours.end()).toBe(true);
    expect(tours.end()).toBe(false);
    const later = new AppState();
    later.projects.value = ready([projectOf()]);
    later.route.value = { name: 'project', id: 'p_1' };
    new TourCommands(later).greet();
    expect(later.tourStop.value).toBeNull();
  });

  it('goes on and back over its five stops, and is over behind the last', () => {
    openProject();
    state.helpShown.value = true;
    tours.begin();
    expect([tourStops.length, state.helpShown.value]).toEqual([5, false]);
    tours.step(-1);
    expect(state.tourStop.value).toBe(0);
    const seen = tourStops.map(() => {
      tours.step(1);
      return state.tourStop.value;
    });
    expect(seen).toEqual([1, 2, 3, 4, null]);
    tours.step(-1);
    expect(state.tourStop.value).toBeNull();
  });
});
