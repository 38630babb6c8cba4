import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { Commands } from './Commands';

export const CommandsContext = createContext<Commands | null>(null);

export function useCommands(): Commands {
  const commands = useContext(CommandsContext);
  if (!commands) throw new Error('a component outside of the page');
  return commands;
}
