// @vitest-environment jsdom

import { screen, waitFor } from '@testing-library/dom';
import { act } from 'preact/test-utils';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { Settings } from '../../src/panels/Settings';
import { SelectionPanel } from '../../src/panels/SelectionPanel';
import { TopBar } from '../../src/panels/TopBar';
import { NumberField } from '../../src/controls/NumberField';
import { speak } from '../../src/texts/language';
import { unit } from '../../src/texts/units';
import { squareOf } from '../fakes';
import { click, openPage, type, type Page } from './page';

let page: Page;
beforeEach(() => {
  localStorage.clear();
  page = openPage();
});
afterEach(async () => {
  await act(() => speak('en'));
});

const radio = (name: string): HTMLInputElement => screen.getByRole('radio', { name });

describe('the settings', () => {
  it('change the language of what stands there, at once and for the next visit', async () => {
    page.show(<TopBar />);
    expect(screen.getByRole('button', { name: 'Start drape' })).toBeTruthy();
    click(screen.getByRole('button', { name: 'Language and units' }));
    expect(radio('English').checked).toBe(true);
    click(radio('Deutsch'));
    await waitFor(() => expect(screen.getByRole('button', { name: 'Drapieren' })).toBeTruthy());
    expect(screen.getByRole('heading', { name: 'Sprache und Einheiten' })).toBeTruthy();
    expect([document.documentElement.lang, localStorage.getItem('toile.language')]).toEqual(['de', 'de']);
    click(radio('English'));
    await waitFor(() => expect(screen.getByRole('button', { name: 'Start drape' })).toBeTruthy());
    expect([document.documentElement.lang, localStorage.getItem('toile.language')]).toEqual(['en', 'en']);
    click(screen.getByRole('button', { name: 'Close' }));
    expect(screen.queryByRole('dialog')).toBeNull();
  });

  it('change the unit of what is shown, at once and for the next visit', () => {
    const piece = squareOf('front', 0, 0, 100);
    page.state.selected.value = 'front';
    page.show(
      <>
        <Settings />
        <SelectionPanel pieces={{ pieces: [piece], seams: [] }} />
      </>,
    );
    expect(document.querySelector('.selection-facts')!.textContent).toContain('100.0 × 100.0 mm');
    click(screen.getByRole('button', { name: 'Language and units' }));
    click(radio('Everything in inches'));
    expect(document.querySelector('.selection-facts')!.textContent).toContain('3.937 × 3.937 in');
    expect([unit.value, localStorage.getItem('toile.lengths')]).toEqual(['inch', 'inch']);
    click(radio('Everything in cm'));
    expect(document.querySelector('.selection-facts')!.textContent).toContain('10.00 × 10.00 cm');
  });
});

describe('a length that is typed', () => {
  it('is taken in the unit that is shown, with the comma of the language', async () => {
    const taken: number[] = [];
    page.show(<NumberField label="Width" value={25.4} length take={(mm) => taken.push(mm)} />);
    const field = (): HTMLInputElement => screen.getByRole('textbox', { name: /^Width/ });
    type(field(), '30');
    page.change(() => (unit.value = 'cm'));
    expect(field().value).toBe('2.54');
    type(field(), '3,5');
    page.change(() => (unit.value = 'inch'));
    expect(field().value).toBe('1.000');
    type(field(), '2');
    await act(() => speak('de'));
    expect(field().value).toBe('1,000');
    type(field(), '0,5');
    type(field(), '1,000');
    expect(taken.map((mm) => Math.round(mm * 1000) / 1000)).toEqual([30, 35, 50.8, 12.7]);
  });
});
