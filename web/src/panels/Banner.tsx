// Says that the connection is gone, when the next try comes, and lets one try now.

import { useAppState } from '../state/context';
import { Icon } from '../controls/Icon';

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
          <b>Connection lost.</b> What you see is the last that came.{' '}
          {seconds > 0 ? `Trying again in ${seconds} s.` : 'Trying again…'}
        </span>
        <button class="plain" onClick={retry}>
          Try now
        </button>
      </div>
    );
  }
  if (stream.state === 'lost' && stream.attempt > 1) {
    return (
      <div class="banner" role="status">
        <Icon name="alert" />
        <span>
          <b>The live view is interrupted.</b> It comes back by itself.
        </span>
        <button class="plain" onClick={retry}>
          Try now
        </button>
      </div>
    );
  }
  return null;
}
