import { dismiss } from '../commands/notices';
import { useAppState } from '../state/context';
import { sentence } from '../state/words';
import { Icon } from '../controls/Icon';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

/** Short news at the edge of the page. */
export function Notices() {
  const state = useAppState();
  return (
    <div class="notices" aria-live="polite">
      {state.notices.value.map((notice) => (
        <div key={notice.id} class={`notice ${notice.tone}`} role={notice.tone === 'bad' ? 'alert' : 'status'}>
          <Icon name={notice.tone === 'bad' ? 'alert' : 'check'} />
          <div>
            <p>{notice.tone === 'bad' ? <Told code={notice.code ?? ''} detail={notice.text} /> : sentence(notice.text)}</p>
            {(notice.code || notice.where) && (
              <p class="code">{[notice.code, notice.where].filter(Boolean).join(' · ')}</p>
            )}
          </div>
          <button class="tool flat" aria-label={t.frame.dismiss} onClick={() => dismiss(state, notice.id)}>
            <Icon name="cross" />
          </button>
        </div>
      ))}
    </div>
  );
}
