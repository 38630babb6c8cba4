// @vitest-environment jsdom
// What the service has not sent yet is told in its place, and so is why it does not come.

import { screen } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { NotThere } from '../../src/panels/NotThere';
import { ApiError } from '../../src/api/http';
import { loading } from '../../src/state/AppState';
import { openPage, type Page } from './page';

let page: Page;
beforeEach(() => {
  page = openPage();
});

describe('the place of what is not there', () => {
  it('tells that it is on its way, also before it was asked for', () => {
    page.show(<NotThere wanted={loading} loading="Asking for the users." />);
    expect(screen.getByRole('status').textContent).toBe('Asking for the users.');
    page.show(<NotThere wanted={null} loading="Asking for the users." />);
    expect(screen.getByRole('status').textContent).toBe('Asking for the users.');
  });

  it('tells why it does not come', () => {
    page.show(<NotThere wanted={{ state: 'failed', error: new ApiError(0, 'net.unreachable', 'no answer') }} loading="Asking for the users." />);
    expect(screen.getByRole('alert').textContent).not.toBe('');
    expect(screen.queryByRole('status')).toBeNull();
  });
});
