// Beside the pattern: the drape as it runs, and what came of it.

import type { PatternUrls } from '../api/patternFiles';
import type { Tab } from '../state/AppState';
import { useAppState } from '../state/context';
import { ArrangePanel } from './ArrangePanel';
import { BodyPanel } from './BodyPanel';
import { DrapeFigures } from './DrapeFigures';
import { Results } from './Results';
import type { MovieMaking } from './Movies';
import type { PictureTaking } from './Pictures';
import { PatternPanel } from './PatternPanel';
import type { PicturesProps } from './Rail';
import { t } from '../texts/language';

const kTabs: readonly Tab[] = ['pattern', 'body', 'arrange', 'drape', 'result'];

export function Inspector(props: PicturesProps & { movies?: MovieMaking & PictureTaking; files?: PatternUrls }) {
  const state = useAppState();
  const shown = state.tab.value;
  const turn = (event: KeyboardEvent): void => {
    if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
    const step = event.key === 'ArrowRight' ? 1 : kTabs.length - 1;
    state.tab.value = kTabs[(kTabs.indexOf(shown) + step) % kTabs.length]!;
    document.getElementById(`tab-${state.tab.value}`)?.focus();
  };
  return (
    <section class="inspector" aria-label={t.frame.inspector}>
      <div class="tabs" role="tablist" onKeyDown={turn}>
        {kTabs.map((tab) => (
          <button
            key={tab}
            role="tab"
            id={`tab-${tab}`}
            aria-selected={shown === tab}
            aria-controls="tab-panel"
            tabIndex={shown === tab ? 0 : -1}
            onClick={() => (state.tab.value = tab)}
          >
            {t.frame.tabs[tab]}
          </button>
        ))}
      </div>
      {/* Each begins at its top, wherever the one before was left. */}
      <div key={shown} class="tab-panel" role="tabpanel" id="tab-panel" aria-labelledby={`tab-${shown}`} tabIndex={0}>
        <h2 class="visually-hidden">{t.frame.tabs[shown]}</h2>
        {shown === 'pattern' && <PatternPanel files={props.files} />}
        {shown === 'body' && <BodyPanel />}
        {shown === 'arrange' && <ArrangePanel />}
        {shown === 'drape' && <DrapeFigures />}
        {shown === 'result' && <Results {...props} />}
      </div>
    </section>
  );
}
