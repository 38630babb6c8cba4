// Links to the shown drape for others: made, copied, taken back.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { ApiError } from '../api/http';
import type { LinkApi } from '../api/links';
import type { Job, ShareLink, Taking } from '../api/types';
import { asApiError } from '../commands/notices';
import { Icon } from '../controls/Icon';
import { useAppState } from '../state/context';
import { isActive } from '../state/jobs';

export function ShareDialog({ links }: { links: LinkApi }) {
  const { sharing, job } = useAppState();
  if (!sharing.value || !job.value) return null;
  return <Dialog key={job.value.id} job={job.value} api={links} close={() => (sharing.value = false)} />;
}

const kTakings: [Taking, string][] = [
  ['pictures', 'Pictures and movies'],
  ['report', 'The report'],
  ['models', '3D models (GLB, OBJ)'],
];
const kTimes: [days: number | null, title: string][] = [
  [1, 'a day'],
  [7, 'a week'],
  [30, 'a month'],
  [365, 'a year'],
  [null, 'ever'],
];
const kUsualDays = 30;

function Dialog({ job, api, close }: { job: Job; api: LinkApi; close: () => void }) {
  const dialog = useRef<HTMLDialogElement>(null);
  const [links, setLinks] = useState<ShareLink[] | null>(null);
  const [fresh, setFresh] = useState('');
  const [error, setError] = useState<ApiError | null>(null);
  useEffect(() => dialog.current?.showModal(), []);
  /** What is asked of the service, and its list afterwards. */
  async function ask(what: () => Promise<void>): Promise<void> {
    setError(null);
    try {
      await what();
      setLinks(await api.links(job.id));
    } catch (failure) {
      setError(asApiError(failure));
    }
  }
  useEffect(() => void api.links(job.id).then(setLinks, (failure: unknown) => setError(asApiError(failure))), [api, job.id]);
  const make = (label: string, days: number | null, take: Taking[]): Promise<void> =>
    ask(async () => {
      const { page } = await api.share(job.id, { label, days, take });
      setFresh(new URL(page, location.href).href);
    });
  const revoke = (link: ShareLink): Promise<void> => ask(() => api.revoke(link.id));
  return (
    <dialog class="sheet share" ref={dialog} onClose={close} aria-labelledby="share-title">
      <header>
        <h2 id="share-title">Share “{job.name}”</h2>
        <button class="tool flat" aria-label="Close" onClick={() => dialog.current?.close()}>
          <Icon name="cross" />
        </button>
      </header>
      <div class="sheet-body">
        <p class="share-lead">
          Whoever has the link sees this drape{isActive(job.state) ? ' as it moves, and what it comes to' : ''}: in 3D, its
          stills and its figures. They need no account, and can change nothing.
        </p>
        {fresh ? <Fresh url={fresh} another={() => setFresh('')} /> : <Wish make={make} />}
        {error && (
          <p class="problem" role="alert">
            {error.detail}
          </p>
        )}
        {links !== null && links.length > 0 && <Given links={links} revoke={(link) => void revoke(link)} />}
      </div>
    </dialog>
  );
}

function Wish({ make }: { make(label: string, days: number | null, take: Taking[]): Promise<void> }) {
  const [label, setLabel] = useState('');
  const [days, setDays] = useState<number | null>(kUsualDays);
  const [take, setTake] = useState<Taking[]>(['pictures', 'report']);
  const [busy, setBusy] = useState(false);
  async function submit(event: Event): Promise<void> {
    event.preventDefault();
    setBusy(true);
    await make(label.trim(), days, take);
    setBusy(false);
  }
  const flip = (what: Taking): void => setTake(take.includes(what) ? take.filter((one) => one !== what) : [...take, what]);
  return (
    <form class="share-wish" onSubmit={(event) => void submit(event)}>
      <fieldset>
        <legend>They may take home</legend>
        {kTakings.map(([what, title]) => (
          <label key={what} class="check">
            <input type="checkbox" checked={take.includes(what)} onChange={() => flip(what)} /> {title}
          </label>
        ))}
      </fieldset>
      <label class="text-field">
        <span>Good for</span>
        <select value={String(days)} onChange={(event) => setDays(Number(event.currentTarget.value) || null)}>
          {kTimes.map(([time, title]) => (
            <option key={title} value={String(time)}>
              {title}
            </option>
          ))}
        </select>
      </label>
      <label class="text-field">
        <span>For whom</span>
        <input
          value={label}
          maxLength={40}
          placeholder="A note for yourself"
          onInput={(event) => setLabel(event.currentTarget.value)}
        />
      </label>
      <button class="primary" type="submit" disabled={busy}>
        <Icon name="share" /> Make a link
      </button>
    </form>
  );
}

/** The one time that the link is told. */
function Fresh({ url, another }: { url: string; another: () => void }) {
  const field = useRef<HTMLInputElement>(null);
  const [copied, setCopied] = useState(false);
  useEffect(() => field.current?.select(), []);
  async function copy(): Promise<void> {
    field.current?.select();
    try {
      await navigator.clipboard.writeText(url);
      setCopied(true);
    } catch {
      // Without https a browser lets no page write there: the link stands selected, for the keys.
      setCopied(document.execCommand('copy'));
    }
  }
  return (
    <div class="share-fresh">
      <div class="share-link">
        <input ref={field} readOnly value={url} aria-label="The link" onFocus={(event) => event.currentTarget.select()} />
        <button class="primary" onClick={() => void copy()}>
          <Icon name={copied ? 'check' : 'copy'} /> {copied ? 'Copied' : 'Copy'}
        </button>
      </div>
      <p>
        It is shown this once: copy it now.{' '}
        <button class="plain small" onClick={another}>
          Make another
        </button>
      </p>
    </div>
  );
}

function Given({ links, revoke }: { links: readonly ShareLink[]; revoke: (link: ShareLink) => void }) {
  return (
    <section class="share-given">
      <h3>Links to this drape</h3>
      <ul>
        {links.map((link) => (
          <li key={link.id} class={link.expired ? 'over' : ''}>
            <div>
              <b>{link.label || 'Without a note'}</b>
              <small>{linkText(link)}</small>
            </div>
            <button class="plain" onClick={() => revoke(link)} aria-label={`Take back ${link.label || 'this link'}`}>
              Take back
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

const kTaken: Record<Taking, string> = { pictures: 'pictures', report: 'report', models: 'models' };

function linkText({ created_ms, expires_ms, expired, take }: ShareLink): string {
  const day = (ms: number): string => new Date(ms).toLocaleDateString('en-GB', { dateStyle: 'medium' });
  const until = expires_ms === 0 ? 'for ever' : expired ? `expired ${day(expires_ms)}` : `until ${day(expires_ms)}`;
  const may = take.length === 0 ? 'to look at only' : `may take ${take.map((one) => kTaken[one]).join(', ')}`;
  return `${day(created_ms)}, ${until} · ${may}`;
}
