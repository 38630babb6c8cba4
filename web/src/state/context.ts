// How components reach the state and the commands.

import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { AppState } from './AppState';

export const StateContext = createContext<AppState | null>(null);

export function useAppState(): AppState {
  const state = useContext(StateContext);
  if (!state) throw new Error('a component outside of the page');
  return state;
}
