// @vitest-environment jsdom
// A modal dialog is gone for the page as soon as it is left, and may be asked for again at once.

import { fireEvent, screen } from '@testing-library/dom';
import { signal } from '@preact/signals';
import { beforeEach, describe, expect, it } from 'vitest';
import { Sheet } from '../../src/controls/Sheet';
import { openPage, type Page } from './page';

const shown = signal(true);
const later = (): Promise<void> => new Promise((done) => setTimeout(done, 5));
const escape = (): boolean => fireEvent(screen.getByRole('dialog'), new Event('cancel', { cancelable: true }));

function Part({ mayLeave }: { mayLeave?: () => boolean }) {
  return shown.value ? (
    <Sheet class="x" id="x" title="A sheet" close={() => (shown.value = false)} {...(mayLeave && { mayLeave })}>
      <p>inside</p>
    </Sheet>
  ) : null;
}

let page: Page;
beforeEach(() => {
  shown.value = true;
  page = openPage();
});

describe('a sheet', () => {
  it('ends what it stands for before Escape has returned', () => {
    page.show(<Part />);
    expect(screen.getByRole<HTMLDialogElement>('dialog', { name: 'A sheet' }).open).toBe(true);
    escape();
    expect(shown.value).toBe(false);
  });

  it('stays when it is asked for again before the browser tells that it was closed', async () => {
    page.show(<Part />);
    escape();
    page.change(() => (shown.value = true));
    await later();
    expect(shown.value).toBe(true);
    expect(screen.getByRole<HTMLDialogElement>('dialog').open).toBe(true);
  });

  it('is not left while it may not be', () => {
    page.show(<Part mayLeave={() => false} />);
    expect(escape()).toBe(false);
    expect(shown.value).toBe(true);
  });

  it('follows a browser that closes it by itself', async () => {
    page.show(<Part />);
    screen.getByRole<HTMLDialogElement>('dialog').close();
    await later();
    expect(shown.value).toBe(false);
  });
});
