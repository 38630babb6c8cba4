// Says that the connection is gone, when the next try comes, and lets one try now.

import { useAppState } from '../state/context';
import { Icon } from '../controls/Icon';
import { t } from '../texts/language';

export function Banner({ retry }: { retry: () => void }) {
  const state = useAppState();
  const link = state.link.value;
  const stream = state.stream.value;
  if (link.state === 'lost') {
    const seconds = Math.max(0, Math.ceil((link.retryAt - state.now.value) / 1000));
    return (
      <div class="banner" role="alert">
        <Icon name="alert" />
        <span>
          <b>{t.frame.lost}</b> {t.frame.lostShows}{' '}
          {seconds > 0 ? t.frame.tryingIn(seconds) : t.frame.trying}
        </span>
        <button class="plain" onClick={retry}>
          {t.frame.tryNow}
        </button>
      </div>
    );
  }
  if (stream.state === 'lost' && stream.attempt > 1) {
    return (
      <div class="banner" role="status">
        <Icon name="alert" />
        <span>
          <b>{t.frame.liveLost}</b> {t.frame.comesBack}
        </span>
        <button class="plain" onClick={retry}>
          {t.frame.tryNow}
        </button>
      </div>
    );
  }
  return null;
}
