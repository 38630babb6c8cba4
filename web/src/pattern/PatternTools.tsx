// The buttons over the 2D view: what the hand does, undo and redo, and who has the large place.

import { useCommands } from '../commands/context';
import { turnsOf } from '../state/steps';
import { useAppState } from '../state/context';
import { patternTools } from '../tools/table';
import { t } from '../texts/language';

export function PatternTools() {
  const { editing } = useAppState();
  return (
    <div class="pattern-tools" role="toolbar" aria-label={t.pattern.tools}>
      <ToolButtons />
      <span class="tool-group">
        <Turns />
        <LargeButton />
      </span>
      {editing.busy.value && <span class="spinner" role="status" aria-label={t.pattern.working} />}
    </div>
  );
}

function ToolButtons() {
  const held = useAppState().editing.tool.value;
  const { pattern } = useCommands();
  return (
    <span class="tool-group">
      {patternTools.map((tool) => (
        <button
          key={tool.id}
          class="tool"
          aria-pressed={held === tool.id}
          title={`${tool.words().hint} (${tool.key})`}
          onClick={() => pattern.takeTool(tool)}
        >
          {tool.words().title}
        </button>
      ))}
    </span>
  );
}

/** Undo and redo, with what they would do. */
function Turns() {
  const { editing, link, known } = useAppState();
  const { edits } = useCommands();
  const { undo, redo } = turnsOf(editing.history.value, known.value);
  const offline = link.value.state === 'lost';
  return (
    <>
      <button
        class="tool flat"
        disabled={!undo || offline}
        title={undo ? t.pattern.undoTip(undo) : t.pattern.noUndo}
        aria-label={undo ? t.pattern.undoWhat(undo) : t.pattern.undo}
        onClick={() => void edits.undo()}
      >
        <Glyph path="M6.2 3L2.8 6.4l3.4 3.4M3 6.4h6.2a3.6 3.6 0 0 1 0 7.2H6" />
      </button>
      <button
        class="tool flat"
        disabled={!redo || offline}
        title={redo ? t.pattern.redoTip(redo) : t.pattern.noRedo}
        aria-label={redo ? t.pattern.redoWhat(redo) : t.pattern.redo}
        onClick={() => void edits.redo()}
      >
        <Glyph path="M9.8 3l3.4 3.4-3.4 3.4M13 6.4H6.8a3.6 3.6 0 0 0 0 7.2H10" />
      </button>
    </>
  );
}

/** Arrows apart, and towards each other. */
const kGrow = 'M9.5 6.5l4-4M10 2.5h3.5V6M6.5 9.5l-4 4M6 13.5H2.5V10';
const kShrink = 'M13.5 2.5l-4 4M9.5 3v3.5H13M2.5 13.5l4-4M6.5 13V9.5H3';

function LargeButton() {
  const { large } = useAppState().editing;
  return (
    <button
      class="tool flat"
      aria-pressed={large.value}
      title={large.value ? t.pattern.smallTip : t.pattern.largeTip}
      aria-label={t.pattern.large}
      onClick={() => (large.value = !large.value)}
    >
      <Glyph path={large.value ? kShrink : kGrow} />
    </button>
  );
}

const Glyph = ({ path }: { path: string }) => (
  <svg class="icon" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
    <path d={path} />
  </svg>
);
