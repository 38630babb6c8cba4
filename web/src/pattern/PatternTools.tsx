// The buttons over the 2D view: what the hand does, undo and redo, and who has the large place.

import { useCommands } from '../commands/context';
import { turnsOf, type Tool } from '../state/editing';
import { useAppState } from '../state/context';

const kTools: { tool: Tool; title: string; key: string; hint: string }[] = [
  { tool: 'pieces', title: 'Pieces', key: 'A', hint: 'Select and move pieces' },
  { tool: 'points', title: 'Points', key: 'Z', hint: 'Edit points, handles and edges' },
  { tool: 'sew', title: 'Sew', key: 'N', hint: 'Click edges together' },
];

export function PatternTools() {
  const state = useAppState();
  const commands = useCommands();
  const { editing } = state;
  const { undo, redo } = turnsOf(editing.history.value);
  const offline = state.link.value.state === 'lost';
  const large = editing.large.value;
  return (
    <div class="pattern-tools" role="toolbar" aria-label="Pattern tools">
      <span class="tool-group">
        {kTools.map(({ tool, title, key, hint }) => (
          <button
            key={tool}
            class="tool"
            aria-pressed={editing.tool.value === tool}
            title={`${hint} (${key})`}
            onClick={() => commands.pattern.takeTool(tool)}
          >
            {title}
          </button>
        ))}
      </span>
      <span class="tool-group">
        <button
          class="tool flat"
          disabled={!undo || offline}
          title={undo ? `Undo: ${undo} (Ctrl+Z)` : 'Nothing to undo'}
          aria-label={undo ? `Undo ${undo}` : 'Undo'}
          onClick={() => void commands.pattern.undo()}
        >
          <Glyph path="M6.2 3L2.8 6.4l3.4 3.4M3 6.4h6.2a3.6 3.6 0 0 1 0 7.2H6" />
        </button>
        <button
          class="tool flat"
          disabled={!redo || offline}
          title={redo ? `Redo: ${redo} (Ctrl+Shift+Z)` : 'Nothing to redo'}
          aria-label={redo ? `Redo ${redo}` : 'Redo'}
          onClick={() => void commands.pattern.redo()}
        >
          <Glyph path="M9.8 3l3.4 3.4-3.4 3.4M13 6.4H6.8a3.6 3.6 0 0 0 0 7.2H10" />
        </button>
        <button
          class="tool flat"
          aria-pressed={large}
          title={large ? 'Small pattern (E)' : 'Large pattern (E)'}
          aria-label="Large pattern"
          onClick={() => (editing.large.value = !large)}
        >
          <Glyph
            path={
              large
                ? 'M13.5 2.5l-4 4M9.5 3v3.5H13M2.5 13.5l4-4M6.5 13V9.5H3'
                : 'M9.5 6.5l4-4M10 2.5h3.5V6M6.5 9.5l-4 4M6 13.5H2.5V10'
            }
          />
        </button>
      </span>
      {editing.busy.value && <span class="spinner" role="status" aria-label="Working" />}
    </div>
  );
}

const Glyph = ({ path }: { path: string }) => (
  <svg class="icon" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
    <path d={path} />
  </svg>
);
