// @vitest-environment jsdom
import { fireEvent, screen, waitFor } from '@testing-library/dom';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { click, openPage, type Page } from './page';
import { ApiError } from '../../src/api/http';
import { LogIn } from '../../src/panels/LogIn';
import { TopBar } from '../../src/panels/TopBar';

const button = (name: string | RegExp): HTMLElement => screen.getByRole('button', { name });

let page: Page;
let doors: { logIn: ReturnType<typeof vi.fn>; logInByToken: ReturnType<typeof vi.fn> };
let entered: ReturnType<typeof vi.fn>;
beforeEach(() => {
  page = openPage();
  doors = { logIn: vi.fn(async () => undefined), logInByToken: vi.fn(async () => undefined) };
  entered = vi.fn();
});

const show = (): void => page.show(<LogIn doors={doors} entered={entered} />);
const fill = (label: string, value: string): void => {
  fireEvent.input(screen.getByLabelText(label), { target: { value } });
};
const send = (): void => void fireEvent.submit(button('Log in').closest('form')!);

describe('the login', () => {
  it('is not there while the door is open', () => {
    show();
    expect(screen.queryByRole('dialog')).toBeNull();
  });

  it('takes a name and a password', async () => {
    page.change((state) => (state.shut.value = true));
    show();
    fill('Name', ' anna ');
    fill('Password', ' correct horse ');
    send();
    await waitFor(() => expect(entered).toHaveBeenCalledOnce());
    expect(doors.logIn).toHaveBeenCalledWith('anna', ' correct horse ');
  });

  it('takes a token', async () => {
    page.change((state) => (state.shut.value = true));
    show();
    click(button('By a token'));
    fill('Token', 'toile_1 ');
    send();
    await waitFor(() => expect(entered).toHaveBeenCalledOnce());
    expect(doors.logInByToken).toHaveBeenCalledWith('toile_1');
  });

  it('says what was wrong and lets one try again', async () => {
    const wrong = new ApiError(401, 'auth.password', 'name and password do not belong together');
    doors.logIn.mockRejectedValueOnce(wrong);
    page.change((state) => (state.shut.value = true));
    show();
    fill('Name', 'anna');
    fill('Password', 'wrong');
    send();
    expect((await screen.findByRole('alert')).textContent).toBe('Name and password do not belong together.');
    expect(entered).not.toHaveBeenCalled();
    send();
    await waitFor(() => expect(entered).toHaveBeenCalledOnce());
  });

  it('tells who was in that they are out, and nobody else', () => {
    page.change((state) => (state.shut.value = true));
    show();
    expect(screen.queryByText(/You are logged out/)).toBeNull();
    page.change((state) => (state.session.value = { accounts: true, name: 'anna', scopes: ['read'], expires_ms: 0 }));
    expect(screen.getByText(/You are logged out/)).toBeTruthy();
  });

  it('cannot be waved away', () => {
    page.change((state) => (state.shut.value = true));
    show();
    const cancel = new Event('cancel', { cancelable: true });
    screen.getByRole('dialog').dispatchEvent(cancel);
    expect(cancel.defaultPrevented).toBe(true);
  });
});

describe('the top bar', () => {
  it('names who is logged in and lets them out', () => {
    page.change((state) => (state.session.value = { accounts: true, name: 'anna', scopes: ['read'], expires_ms: 0 }));
    page.show(<TopBar />);
    click(button('Log out anna'));
    expect(page.asked()).toEqual([['logOut']]);
  });

  it('says nothing of accounts where there are none', () => {
    page.change((state) => (state.session.value = { accounts: false, name: null, scopes: ['read'], expires_ms: 0 }));
    page.show(<TopBar />);
    expect(screen.queryByRole('button', { name: /Log out/ })).toBeNull();
  });
});
