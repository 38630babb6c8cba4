// What stands beside the cloth on the page of a share link: how the drape goes or went, its pictures and figures, and what
// may be taken home. Nothing here changes anything.

import { useSignal } from '@preact/signals';
import type { SharedApi } from '../api/links';
import type { SharedJob } from '../api/types';
import { Icon } from '../controls/Icon';
import { useAppState } from '../state/context';
import { isActive, overall, activity } from '../state/jobs';
import { reportLines, stillsOf } from '../state/report';
import { goodUntil, takenHome } from '../state/shared';
import { percent } from '../state/words';
import { Enlarged, FileLink, Lines, stillName, Stills } from './DrapeParts';
import { FitTable } from './FitTable';
import { t } from '../texts/language';
import { sentence, told } from '../texts/told';

const kEnlarged = 1024;

export function SharedPanel({ job, api }: { job: SharedJob; api: SharedApi }) {
  const large = useSignal<string | null>(null);
  const stills = stillsOf(Object.fromEntries(job.stills.map((name) => [name, 0])));
  return (
    <aside class="shared-panel" aria-label={t.share.about}>
      {isActive(job.state) ? <Live job={job} /> : <Ending job={job} />}
      {stills.length > 0 && (
        <Stills names={stills} urlOf={(name, width) => api.stillUrl(job.id, name, width ?? kEnlarged)} enlarge={(name) => (large.value = name)} />
      )}
      {job.report && (
        <>
          <h2>{t.share.cameOut}</h2>
          <Lines lines={reportLines(job.report)} />
          <FitTable report={job.report} />
        </>
      )}
      <TakeHome job={job} api={api} />
      <p class="shared-until">{goodUntil(job.expires_ms)}</p>
      {large.value && (
        <Enlarged
          url={api.stillUrl(job.id, large.value, kEnlarged)}
          name={stillName(large.value)}
          close={() => (large.value = null)}
        />
      )}
    </aside>
  );
}

/** A drape under way, as it goes. */
function Live({ job }: { job: SharedJob }) {
  const now = useAppState().progress.value ?? job.progress;
  const done = now ? overall(now.phase, now.fraction) : 0;
  return (
    <div class={`shared-live state-${job.state}`} role="status">
      <p>
        <b>{activity(job.state, now?.phase)}</b>
        <span>{percent(done, 0)}</span>
      </p>
      <div class="bar">
        <i style={{ width: `${100 * done}%` }} />
      </div>
      <small>{t.share.live}</small>
    </div>
  );
}

function Ending({ job }: { job: SharedJob }) {
  if (job.state === 'succeeded') return null;
  const title = job.state === 'cancelled' ? t.share.wasCancelled : t.share.didNotWork;
  return (
    <div class="reason reason-bad">
      <h3>{title}</h3>
      {job.reason && <p>{sentence(told(job.reason_code, job.reason).text)}</p>}
    </div>
  );
}

function TakeHome({ job, api }: { job: SharedJob; api: SharedApi }) {
  const files = takenHome(job);
  const stills = stillsOf(job.results);
  const page = job.take.includes('report') && job.report !== null;
  if (files.length + stills.length === 0 && !page) return null;
  return (
    <>
      <h2>{t.share.takeHome}</h2>
      <ul class="downloads">
        {page && (
          <li>
            <a href={api.reportUrl(job.id)} target="_blank" rel="noreferrer">
              <Icon name="file" />
              <span>
                <b>{t.share.reportToRead}</b>
                <small>{t.share.reportHint}</small>
              </span>
            </a>
          </li>
        )}
        {files.map((file) => (
          <FileLink key={file.name} file={file} url={api.fileUrl(job.id, file.name)} of={job.name} />
        ))}
        {stills.map((name) => {
          const file = { name, title: 'PNG', hint: t.report.still(stillName(name)), bytes: job.results[name]! };
          return <FileLink key={name} file={file} url={api.fileUrl(job.id, name)} of={job.name} />;
        })}
      </ul>
    </>
  );
}
