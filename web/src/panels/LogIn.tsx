// Asks who it is, where the service lets in only who is known.

import { useState } from 'preact/hooks';
import type { Api } from '../api/Api';
import type { ApiError } from '../api/http';
import { asApiError } from '../commands/notices';
import { useModal } from '../controls/Sheet';
import { useAppState } from '../state/context';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

type Doors = Pick<Api, 'logIn' | 'logInByToken'>;

/** `entered` is called once somebody is known. */
export function LogIn({ doors, entered }: { doors: Doors; entered: () => void }) {
  return useAppState().shut.value ? <Dialog doors={doors} entered={entered} /> : null;
}

function Dialog({ doors, entered }: { doors: Doors; entered: () => void }) {
  // Nobody leaves it but by saying who it is.
  const { ref, onCancel } = useModal(() => undefined, () => false);
  const wasIn = useAppState().session.value !== null;
  const [byToken, setByToken] = useState(false);
  const [busy, setBusy] = useState(false);
  const [error, setError] = useState<ApiError | null>(null);
  async function enter(event: Event): Promise<void> {
    event.preventDefault();
    const said = new FormData(event.currentTarget as HTMLFormElement);
    const text = (name: string): string => {
      const value = said.get(name);
      return typeof value === 'string' ? value : '';
    };
    setBusy(true);
    setError(null);
    try {
      if (byToken) await doors.logInByToken(text('token').trim());
      else await doors.logIn(text('name').trim(), text('password'));
      entered();
    } catch (failure) {
      setError(asApiError(failure));
    }
    setBusy(false);
  }
  return (
    <dialog class="sheet login" ref={ref} onCancel={onCancel} aria-labelledby="login-title">
      <header>
        <h2 id="login-title">{t.frame.logIn}</h2>
      </header>
      <form onSubmit={(event) => void enter(event)}>
        <div class="sheet-body">
          {wasIn && <p class="hint">{t.frame.loggedOut}</p>}
          {byToken ? <TokenField /> : <PasswordFields />}
          {error && (
            <p class="problem" role="alert">
              <Told code={error.code} detail={error.detail} />
            </p>
          )}
        </div>
        <footer>
          <button type="button" class="plain" onClick={() => setByToken(!byToken)}>
            {byToken ? t.frame.byPassword : t.frame.byToken}
          </button>
          <button type="submit" class="primary" disabled={busy}>
            {t.frame.logIn}
          </button>
        </footer>
      </form>
    </dialog>
  );
}

function PasswordFields() {
  return (
    <>
      <label class="text-field">
        <span>{t.common.name}</span>
        <input name="name" autocomplete="username" autocapitalize="none" spellcheck={false} required autofocus />
      </label>
      <label class="text-field">
        <span>{t.frame.password}</span>
        <input name="password" type="password" autocomplete="current-password" required />
      </label>
    </>
  );
}

function TokenField() {
  return (
    <label class="text-field">
      <span>{t.frame.token}</span>
      <input name="token" type="password" autocomplete="off" placeholder="toile_…" required autofocus />
    </label>
  );
}
