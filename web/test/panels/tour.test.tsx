// @vitest-environment jsdom
import { screen } from '@testing-library/dom';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { click, openPage, type Page } from './page';
import { HelpDialog } from '../../src/panels/HelpDialog';
import { Tour } from '../../src/panels/Tour';
import { TourButton } from '../../src/panels/TourButton';
import { tourStops } from '../../src/state/tour';

const button = (name: string): HTMLElement => screen.getByRole('button', { name });

let page: Page;
beforeEach(() => {
  vi.stubGlobal(
    'ResizeObserver',
    class {
      observe = (): void => undefined;
      disconnect = (): void => undefined;
    },
  );
  Element.prototype.scrollIntoView = () => undefined;
  Element.prototype.getClientRects = () => [{}] as unknown as DOMRectList;
  page = openPage();
});

describe('the tour', () => {
  it('has a card for each stop, with a ring around the place that is there', () => {
    page.show(
      <>
        <div class="pattern" />
        <Tour />
      </>,
    );
    expect(screen.queryByRole('region', { name: 'Tour of the page' })).toBeNull();
    const titles = tourStops.map((_, i) => {
      page.change((state) => (state.tourStop.value = i));
      expect(screen.getByText(`${i + 1} of 5`)).toBeTruthy();
      expect(document.querySelector('.tour-ring') !== null).toBe(tourStops[i]!.places.includes('.pattern'));
      return screen.getByRole('heading').textContent;
    });
    expect(new Set(titles).size).toBe(5);
    expect(screen.queryByRole('button', { name: 'Next' })).toBeNull();
    expect(screen.queryByRole('button', { name: 'Skip' })).toBeNull();
    for (const name of ['Back', 'Done']) click(button(name));
    page.change((state) => (state.tourStop.value = 0));
    click(button('Skip'));
    expect(page.asked()).toEqual([['tours.step', -1], ['tours.step', 1], ['tours.end']]);
    page.change((state) => (state.route.value = { name: 'home' }));
    expect(screen.queryByRole('region', { name: 'Tour of the page' })).toBeNull();
  });

  it('is taken again from the list of keys', () => {
    page.change((state) => (state.helpShown.value = true));
    page.show(<HelpDialog />);
    click(button('Take the tour'));
    expect(page.asked()).toEqual([['tours.begin']]);
  });

  it('is taken again from a dialog, which is left', () => {
    const begun = vi.fn();
    page.show(<TourButton begun={begun} />);
    click(button('Take the tour'));
    expect(begun).toHaveBeenCalledOnce();
    expect(page.asked()).toEqual([['tours.begin']]);
  });
});
