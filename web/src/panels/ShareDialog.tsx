// Links to the shown drape for others: made, copied, taken back.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { ApiError } from '../api/http';
import type { LinkApi } from '../api/links';
import type { Job, ShareLink, Taking } from '../api/types';
import { asApiError } from '../commands/notices';
import { Icon } from '../controls/Icon';
import { Sheet } from '../controls/Sheet';
import { useAppState } from '../state/context';
import { isActive } from '../state/jobs';
import type { Texts } from '../texts/en';
import { day } from '../texts/numbers';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

export function ShareDialog({ links }: { links: LinkApi }) {
  const { sharing, job } = useAppState();
  if (!sharing.value || !job.value) return null;
  return <Dialog key={job.value.id} job={job.value} api={links} close={() => (sharing.value = false)} />;
}

const kTakings: readonly Taking[] = ['pictures', 'report', 'models'];
const kTimes: [days: number | null, time: keyof Texts['share']['times']][] = [
  [1, 'day'],
  [7, 'week'],
  [30, 'month'],
  [365, 'year'],
  [null, 'ever'],
];
const kUsualDays = 30;

function Dialog({ job, api, close }: { job: Job; api: LinkApi; close: () => void }) {
  const [links, setLinks] = useState<ShareLink[] | null>(null);
  const [fresh, setFresh] = useState('');
  const [error, setError] = useState<ApiError | null>(null);
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
    <Sheet class="share" id="share-title" title={t.share.title(job.name)} close={close}>
      <div class="sheet-body">
        <p class="share-lead">
          {isActive(job.state) ? t.share.leadLive : t.share.lead}
        </p>
        {fresh ? <Fresh url={fresh} another={() => setFresh('')} /> : <Wish make={make} />}
        {error && (
          <p class="problem" role="alert">
            <Told code={error.code} detail={error.detail} />
          </p>
        )}
        {links !== null && links.length > 0 && <Given links={links} revoke={(link) => void revoke(link)} />}
      </div>
    </Sheet>
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
        <legend>{t.share.mayTake}</legend>
        {kTakings.map((what) => (
          <label key={what} class="check">
            <input type="checkbox" checked={take.includes(what)} onChange={() => flip(what)} /> {t.share.takings[what]}
          </label>
        ))}
      </fieldset>
      <label class="text-field">
        <span>{t.share.goodFor}</span>
        <select value={String(days)} onChange={(event) => setDays(Number(event.currentTarget.value) || null)}>
          {kTimes.map(([time, name]) => (
            <option key={name} value={String(time)}>
              {t.share.times[name]}
            </option>
          ))}
        </select>
      </label>
      <label class="text-field">
        <span>{t.share.forWhom}</span>
        <input
          value={label}
          maxLength={40}
          placeholder={t.share.note}
          onInput={(event) => setLabel(event.currentTarget.value)}
        />
      </label>
      <button class="primary" type="submit" disabled={busy}>
        <Icon name="share" /> {t.share.make}
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
        <input ref={field} readOnly value={url} aria-label={t.share.theLink} onFocus={(event) => event.currentTarget.select()} />
        <button class="primary" onClick={() => void copy()}>
          <Icon name={copied ? 'check' : 'copy'} /> {copied ? t.share.copied : t.share.copy}
        </button>
      </div>
      <p>
        {t.share.onceOnly}{' '}
        <button class="plain small" onClick={another}>
          {t.share.another}
        </button>
      </p>
    </div>
  );
}

function Given({ links, revoke }: { links: readonly ShareLink[]; revoke: (link: ShareLink) => void }) {
  return (
    <section class="share-given">
      <h3>{t.share.links}</h3>
      <ul>
        {links.map((link) => (
          <li key={link.id} class={link.expired ? 'over' : ''}>
            <div>
              <b>{link.label || t.share.withoutNote}</b>
              <small>{linkText(link)}</small>
            </div>
            <button class="plain" onClick={() => revoke(link)} aria-label={t.share.takeBackWhat(link.label || t.share.thisLink)}>
              {t.share.takeBack}
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}



function linkText({ created_ms, expires_ms, expired, take }: ShareLink): string {
  
  const last = day(expires_ms);
  const until = expires_ms === 0 ? t.share.forEver : expired ? t.share.expired(last) : t.share.until(last);
  const may = take.length === 0 ? t.share.lookOnly : t.share.mayTakeWhat(take.map((one) => t.share.taken[one]).join(', '));
  return `${day(created_ms)}, ${until} · ${may}`;
}
