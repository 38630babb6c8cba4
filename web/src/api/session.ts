// How somebody comes in and goes, and who they are.

import type { Http } from './http';
import type { Question, Session } from './types';

export interface SessionApi {
  /** Who asks. @throws ApiError with status 401 where nobody is known. */
  session(): Promise<Session>;
  logIn(name: string, password: string): Promise<void>;
  logInByToken(token: string): Promise<void>;
  logOut(): Promise<void>;
}

export function makeSessionApi(http: Http): SessionApi {
  const enter = async (shown: Question<'logIn'>): Promise<void> => {
    const headers = { 'Content-Type': 'application/json' };
    await http.send('/session', { method: 'POST', headers, body: JSON.stringify(shown) });
  };
  return {
    session: () => http.get('/session'),
    logIn: (name, password) => enter({ name, password }),
    logInByToken: (token) => enter({ token }),
    logOut: async () => void (await http.send('/session', { method: 'DELETE' })),
  };
}
