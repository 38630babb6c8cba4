// The service for whoever runs it: its load, who there is and what each keeps, and everybody's drapes that have not ended.

import type { ComponentChildren } from 'preact';
import type { AdminAccount, AdminJob, AdminLoad } from '../api/admin';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import type { Loaded } from '../state/AppState';
import { isClosedTo, keptBy, mayLock, type AdminView } from '../state/admin';
import { ago, bytes, count, duration } from '../state/words';
import { t } from '../texts/language';
import { day } from '../texts/numbers';
import { NotThere } from './NotThere';
import { StateChip } from './StateChip';

export function AdminPanel() {
  const { admin, session } = useAppState();
  return (
    <div class="admin">
      <h1>{t.admin.title}</h1>
      {isClosedTo(session.value) ? <p class="hint">{t.admin.notYours(session.value?.name ?? '')}</p> : <Shown view={admin.value} />}
    </div>
  );
}

function Shown({ view }: { view: Loaded<AdminView> }) {
  if (view.state !== 'ready') return <NotThere wanted={view} loading={t.admin.loading} />;
  const { load, accounts, jobs } = view.value;
  return (
    <>
      <Load load={load} kept={keptBy(accounts)} />
      <Accounts accounts={accounts} />
      <Jobs jobs={jobs} />
    </>
  );
}

function Load({ load, kept }: { load: AdminLoad; kept: number }) {
  const failures = Object.entries(load.store_failures);
  const figures: [string, string, string?][] = [
    [t.admin.load.running, count(load.jobs_running)],
    [t.admin.load.queued, count(load.jobs_queued)],
    [t.admin.load.paused, count(load.jobs_paused)],
    [t.admin.load.viewers, count(load.viewers)],
    [t.admin.load.kept, bytes(kept)],
    [t.admin.load.free, bytes(load.disk_free_bytes), t.admin.load.of(bytes(load.disk_bytes))],
  ];
  return (
    <section aria-label={t.admin.load.title}>
      <h2>{t.admin.load.title}</h2>
      <dl class="admin-figures">
        {figures.map(([name, figure, of]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>
              {figure}
              {of && <small> {of}</small>}
            </dd>
          </div>
        ))}
      </dl>
      {!load.ready && (
        <p class="problem" role="alert">
          {t.admin.load.notReady}
        </p>
      )}
      {failures.length > 0 && (
        <p class="problem">
          {t.admin.load.failures} {failures.map(([code, n]) => `${code} (${count(n)})`).join(', ')}
        </p>
      )}
    </section>
  );
}

interface Row {
  key: string;
  locked?: boolean;
  /** What the row is about, then one for each further head. */
  cells: readonly ComponentChildren[];
}

/** Where there is no room for its columns, each row is a block in which every figure stands beside its head. */
function Table({ title, heads, rows }: { title: string; heads: readonly string[]; rows: readonly Row[] }) {
  // The roles are said, since what is laid out otherwise is no table any more to those who do not see it.
  return (
    <section aria-label={title}>
      <h2>{title}</h2>
      <table role="table">
        <thead role="rowgroup">
          <tr role="row">
            {heads.map((head) => (
              <th key={head} role="columnheader" scope="col">
                {head}
              </th>
            ))}
          </tr>
        </thead>
        <tbody role="rowgroup">
          {rows.map(({ key, locked = false, cells: [about, ...figures] }) => (
            <tr key={key} role="row" class={locked ? 'locked' : ''}>
              <th role="rowheader" scope="row">
                {about}
              </th>
              {figures.map((figure, i) => (
                <td key={i} role="cell" data-head={heads[i + 1]}>
                  {figure}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

function Accounts({ accounts }: { accounts: readonly AdminAccount[] }) {
  const { heads, title } = t.admin.accounts;
  return (
    <Table
      title={title}
      heads={[heads.name, heads.keeps, heads.projects, heads.drapes, heads.unfinished, heads.since, heads.access]}
      rows={accounts.map((account) => ({
        key: account.id,
        locked: account.locked,
        cells: [
          <AccountName account={account} />,
          bytes(account.bytes),
          count(account.projects),
          count(account.jobs),
          count(account.unfinished_jobs),
          account.created_ms > 0 ? day(account.created_ms) : '–',
          <Access account={account} />,
        ],
      }))}
    />
  );
}

const nameOf = (account: AdminAccount): string => account.name ?? t.admin.single;

function AccountName({ account }: { account: AdminAccount }) {
  return (
    <>
      {nameOf(account)} {account.admin && <small>{t.admin.accounts.admin}</small>}
      {account.locked && <small class="warn">{t.admin.accounts.locked}</small>}
    </>
  );
}

/** Whether it is let in, and the button that changes that. */
function Access({ account }: { account: AdminAccount }) {
  const commands = useCommands().admin;
  const session = useAppState().session.value;
  const { lock, unlock, of, you } = t.admin.accounts;
  if (!mayLock(account, session)) return <>{account.name !== null && account.name === session?.name ? you : '–'}</>;
  const label = account.locked ? unlock : lock;
  return (
    <button class="plain" aria-label={of(label, nameOf(account))} onClick={() => void commands.lock(account.id, !account.locked)}>
      {label}
    </button>
  );
}

function Jobs({ jobs }: { jobs: readonly AdminJob[] }) {
  const { heads, title, none, priorities } = t.admin.jobs;
  const now = useAppState().now.value;
  if (jobs.length === 0)
    return (
      <section aria-label={title}>
        <h2>{title}</h2>
        <p class="hint">{none}</p>
      </section>
    );
  // Who works on it tells something only where several programs do.
  const many = new Set(jobs.map((job) => job.holder).filter(Boolean)).size > 1;
  return (
    <Table
      title={title}
      heads={[heads.name, heads.account, heads.state, heads.priority, heads.worked, heads.begun, ...(many ? [heads.holder] : [])]}
      rows={jobs.map((job) => ({
        key: job.id,
        cells: [
          job.name,
          job.account ?? t.admin.single,
          <StateChip state={job.state} />,
          priorities[job.priority],
          duration(job.worked_s),
          ago(job.started_ms || job.created_ms, now),
          ...(many ? [job.holder || '–'] : []),
        ],
      }))}
    />
  );
}
