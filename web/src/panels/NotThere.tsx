// What is seen in the place of something that the service has not sent: that it is on its way, or why it does not come.

import type { Loaded } from '../state/AppState';
import { useAppState } from '../state/context';
import { Told } from '../texts/Message';

interface Props {
  wanted: Exclude<Loaded<unknown>, { state: 'ready' }> | null;
  /** The words while it is on its way. */
  loading: string;
}

export function NotThere({ wanted, loading }: Props) {
  // Who has to log in first is asked to by a dialog, and needs no second word of it here.
  if (useAppState().shut.value) return null;
  if (wanted?.state === 'failed')
    return (
      <p class="problem" role="alert">
        <Told code={wanted.error.code} detail={wanted.error.detail} />
      </p>
    );
  return (
    <p class="hint" role="status">
      {loading}
    </p>
  );
}
