// Sews edges together: those of one side are clicked, then those of the other.

import type { AppState } from '../state/AppState';
import type { PatternTool } from './PatternTool';
import { sewByKeys, sewing } from './sewing';
import { t } from '../texts/language';

export const sew: PatternTool = {
  ...sewing,
  id: 'sew',
  words: () => t.keys.tools.sew,
  key: 'N',
  edges: { tabbed: 'all', press: sewByKeys },
  say: ({ editing }: AppState) => {
    const { side, a } = editing.draft.value;
    return (
      <>
        {side === 'a' || a.length === 0 ? t.keys.sewOne : t.keys.sewOther} <kbd>{t.keys.names.Enter}</kbd>
      </>
    );
  },
};
