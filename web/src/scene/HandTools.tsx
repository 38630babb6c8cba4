// The hands that a person may put on cloth while it drapes: buttons beside those of the view.

import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import type { HandTool } from '../state/hands';
import { t } from '../texts/language';

const kTools: { tool: Exclude<HandTool, 'look'>; key: string }[] = [
  { tool: 'pull', key: 'G' },
  { tool: 'pin', key: 'I' },
];

export function HandTools() {
  const { hands, touchable } = useAppState();
  const commands = useCommands();
  if (!touchable.value) return null;
  return (
    <>
      <span class="tool-gap" />
      {kTools.map(({ tool, key }) => (
        <button
          key={tool}
          class="tool"
          aria-pressed={hands.tool.value === tool}
          title={`${t.scene.hands[tool].tip} (${key})`}
          onClick={() => commands.live.take(tool)}
        >
          {t.scene.hands[tool].name}
        </button>
      ))}
    </>
  );
}

/** What the tool that is held does. */
export function HandHint() {
  const { hands, touchable } = useAppState();
  const tool = hands.tool.value;
  if (!touchable.value || tool === 'look') return null;
  return (
    <p class="scene-hint" role="status">
      {t.scene.hands[tool].hint}
    </p>
  );
}
