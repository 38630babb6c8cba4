// @vitest-environment jsdom
import { fireEvent, screen, waitFor } from '@testing-library/dom';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { choose, click, openPage, type Page } from './page';
import { ApiError } from '../../src/api/http';
import { makeSharedApi, type LinkApi } from '../../src/api/links';
import type { ShareLink } from '../../src/api/types';
import { Enlarged, FileLink, Lines, Stills } from '../../src/panels/DrapeParts';
import { ShareDialog } from '../../src/panels/ShareDialog';
import { SharedFrame, SharedTold } from '../../src/panels/SharedFrame';
import { SharedPanel } from '../../src/panels/SharedPanel';
import { ready } from '../../src/state/AppState';
import { SharedState } from '../../src/state/shared';
import { jobOf } from '../fakes';
import { reportOf } from '../samples';
import { sharedOf } from '../sharedJob';

const api = makeSharedApi();
let page: Page;
beforeEach(() => {
  page = openPage();
});

const linkOf = (more: Partial<ShareLink> = {}): ShareLink => ({
  id: 'l_1', job: 'j_1', label: 'Atelier', take: ['report'], created_ms: 1, expires_ms: 0, expired: false, ...more,
});

describe('the dialog of share links', () => {
  const links: LinkApi = {
    links: vi.fn(async () => [linkOf()]),
    share: vi.fn(async () => ({ link: linkOf(), page: '/#/shared/toile_abc' })),
    revoke: vi.fn(async () => undefined),
  };
  const open = (): void => {
    page.change((state) => {
      state.jobs.value = ready([jobOf({ state: 'succeeded' })]);
      state.sharing.value = true;
    });
    page.show(<ShareDialog links={links} />);
  };

  it('makes one by what is ticked and shows it once, to copy', async () => {
    open();
    click(screen.getByLabelText('3D models (GLB, OBJ)'));
    click(screen.getByLabelText('The report'));
    choose(screen.getByLabelText('Good for'), '7');
    fireEvent.submit(screen.getByText('Make a link').closest('form')!);
    await waitFor(() => screen.getByLabelText('The link'));
    expect(links.share).toHaveBeenCalledWith('j_1', { label: '', days: 7, take: ['pictures', 'models'] });
    expect(screen.getByLabelText<HTMLInputElement>('The link').value).toMatch(/\/#\/shared\/toile_abc$/);
  });

  it('lists those that there are, and takes them back', async () => {
    open();
    await waitFor(() => screen.getByText('Atelier'));
    expect(screen.getByText(/for ever · may take report/)).toBeTruthy();
    click(screen.getByLabelText('Take back Atelier'));
    await waitFor(() => expect(links.revoke).toHaveBeenCalledWith('l_1'));
  });

  it('is there for the shown drape only when it is asked for', () => {
    page.show(<ShareDialog links={links} />);
    expect(document.querySelector('dialog')).toBeNull();
  });
});

describe('the page of a share link', () => {
  const frame = (shared: SharedState, again = vi.fn()): void =>
    page.show(
      <SharedFrame shared={shared} api={api} again={again}>
        <SharedTold shared={shared} />
      </SharedFrame>,
    );
  const show = (more: Parameters<typeof sharedOf>[0]): void => page.show(<SharedPanel job={sharedOf(more)} api={api} />);

  it('tells why a link opens nothing', () => {
    const shared = new SharedState();
    shared.job.value = { state: 'failed', error: new ApiError(410, 'links.revoked', '') };
    frame(shared);
    expect(screen.getByRole('heading').textContent).toBe('This link was taken back');
    expect(screen.queryByText('Try again')).toBeNull();
  });

  it('offers to ask again where that may help', () => {
    const again = vi.fn();
    const shared = new SharedState();
    shared.job.value = { state: 'failed', error: new ApiError(0, 'net.unreachable', '') };
    frame(shared, again);
    click(screen.getByText('Try again'));
    expect(again).toHaveBeenCalled();
  });

  it('has no control that changes anything', () => {
    const shared = new SharedState();
    shared.job.value = ready(sharedOf({ state: 'running', take: ['pictures', 'models', 'report'] }));
    frame(shared);
    const words = [...document.querySelectorAll('button')].map((button) => button.textContent);
    // The one that is no picture opens language and units, which are the reader's own.
    expect(words.filter((word) => !word?.includes('Front'))).toEqual(['']);
    expect(screen.getByRole('button', { name: 'Language and units' })).toBeTruthy();
  });

  it('shows stills, figures and the way home of what may be taken', () => {
    show({ take: ['models', 'report'], results: { 'final.glb': 1000 }, report: reportOf() });
    expect(document.querySelector<HTMLImageElement>('.stills img')!.src).toMatch(/shared\/l_1\/results\/front.png\/small\?width=320/);
    expect(screen.getByText('Take home')).toBeTruthy();
    expect([...document.querySelectorAll('.downloads b')].map((one) => one.textContent)).toEqual(['Report to read', 'GLB']);
    expect(document.querySelectorAll('.report li').length).toBeGreaterThan(3);
  });

  it('offers nothing to take where the owner allows nothing', () => {
    show({ report: reportOf() });
    expect(screen.queryByText('Take home')).toBeNull();
  });

  it('says how far a live drape is', () => {
    show({ state: 'running', stills: [], progress: null });
    expect(screen.getByRole('status').textContent).toContain('Starting');
  });
});

describe('parts of a drape', () => {
  it('show a still, the whole one and a file', () => {
    const enlarge = vi.fn();
    page.show(
      <>
        <Stills names={['front.png']} urlOf={(name) => name} enlarge={enlarge} />
        <Lines lines={[{ label: 'Seams', value: 'Closed', sentence: 'All.', verdict: 'good' }]} />
        <FileLink file={{ name: 'final.glb', title: 'GLB', hint: '', bytes: 1 }} url="x" of="Skirt" />
        <Enlarged url="y" name="Front" close={() => undefined} />
      </>,
    );
    click(screen.getByLabelText('Front still, enlarge'));
    expect(enlarge).toHaveBeenCalledWith('front.png');
    expect(screen.getByText('GLB').closest('a')!.download).toBe('Skirt final.glb');
    expect(screen.getByText('Closed')).toBeTruthy();
  });
});
