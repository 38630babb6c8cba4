// The service for whoever runs it: its load, who there is and what each keeps, and everybody's drapes that have not ended.

import type { ComponentChildren } from 'preact';
import type { AdminAccount, AdminJob, AdminLoad } from '../api/admin';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { mayLock, type AdminView } from '../state/admin';
import { ago, bytes, count, duration } from '../state/words';
import { t } from '../texts/language';
import { day } from '../texts/numbers';
import { NotThere } from './NotThere';
import { StateChip } from './StateChip';

export function AdminPanel() {
  const shown = useAppState().admin.value;
  if (shown.state !== 'ready') return <NotThere wanted={shown} loading={t.admin.loading} />;
  return <Shown view={shown.value} />;
}

function Shown({ view }: { view: AdminView }) {
  return (
    <div class="admin">
      <h1>{t.admin.title}</h1>
      <Load load={view.load} />
      <Accounts accounts={view.accounts} />
      <Jobs jobs={view.jobs} />
    </div>
  );
}

function Load({ load }: { load: AdminLoad }) {
  const failures = Object.entries(load.store_failures);
  const figures: [string, string][] = [
    [t.admin.load.running, count(load.jobs_running)],
    [t.admin.load.queued, count(load.jobs_queued)],
    [t.admin.load.paused, count(load.jobs_paused)],
    [t.admin.load.viewers, count(load.viewers)],
    [t.admin.load.disk, bytes(load.disk_bytes)],
    [t.admin.load.free, bytes(load.disk_free_bytes)],
  ];
  return (
    <section aria-label={t.admin.load.title}>
      <h2>{t.admin.load.title}</h2>
      <dl class="admin-figures">
        {figures.map(([name, figure]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{figure}</dd>
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

interface TableProps {
  title: string;
  heads: readonly string[];
  children: ComponentChildren;
}

function Table({ title, heads, children }: TableProps) {
  return (
    <section aria-label={title}>
      <h2>{title}</h2>
      <div class="admin-scroll" tabIndex={0} role="group" aria-label={title}>
        <table>
          <thead>
            <tr>
              {heads.map((head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>{children}</tbody>
        </table>
      </div>
    </section>
  );
}

function Accounts({ accounts }: { accounts: readonly AdminAccount[] }) {
  const { heads } = t.admin.accounts;
  return (
    <Table
      title={t.admin.accounts.title}
      heads={[heads.name, heads.keeps, heads.projects, heads.drapes, heads.unfinished, heads.since, heads.door]}
    >
      {accounts.map((account) => (
        <Account key={account.id} account={account} />
      ))}
    </Table>
  );
}

function Account({ account }: { account: AdminAccount }) {
  const commands = useCommands().admin;
  const session = useAppState().session.value;
  const name = account.name ?? t.admin.single;
  const door = account.locked ? t.admin.accounts.unlock : t.admin.accounts.lock;
  return (
    <tr class={account.locked ? 'locked' : ''}>
      <th scope="row">
        {name} {account.admin && <small>{t.admin.accounts.admin}</small>}
        {account.locked && <small class="warn">{t.admin.accounts.locked}</small>}
      </th>
      <td>{bytes(account.bytes)}</td>
      <td>{count(account.projects)}</td>
      <td>{count(account.jobs)}</td>
      <td>{count(account.unfinished_jobs)}</td>
      <td>{account.created_ms > 0 ? day(account.created_ms) : '–'}</td>
      <td>
        {mayLock(account, session) && (
          <button class="plain" aria-label={t.admin.accounts.of(door, name)} onClick={() => void commands.lock(account.id, !account.locked)}>
            {door}
          </button>
        )}
      </td>
    </tr>
  );
}

function Jobs({ jobs }: { jobs: readonly AdminJob[] }) {
  const { heads, title } = t.admin.jobs;
  const { now } = useAppState();
  if (jobs.length === 0)
    return (
      <section aria-label={title}>
        <h2>{title}</h2>
        <p class="hint">{t.admin.jobs.none}</p>
      </section>
    );
  return (
    <Table title={title} heads={[heads.name, heads.account, heads.state, heads.priority, heads.worked, heads.begun, heads.holder]}>
      {jobs.map((job) => (
        <tr key={job.id}>
          <th scope="row">{job.name}</th>
          <td>{job.account ?? t.admin.single}</td>
          <td>
            <StateChip state={job.state} />
          </td>
          <td>{t.admin.jobs.priorities[job.priority]}</td>
          <td>{duration(job.worked_s)}</td>
          <td>{ago(job.started_ms || job.created_ms, now.value)}</td>
          <td>{job.holder || '–'}</td>
        </tr>
      ))}
    </Table>
  );
}
