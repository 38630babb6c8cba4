// What became of every entity of the file, with line and reason, and the warnings with piece and place.

import { useSignal } from '@preact/signals';
import { useCommands } from '../commands/context';
import type { Import, ImportedEntity, ImportWarning } from '../api/types';
import {
  accountsOf,
  entitiesShown,
  linesText,
  warningsShown,
  type Accounts,
  type ReportFilter,
} from '../state/importDraft';
import { count, counted, sentence } from '../state/words';
import { Icon } from '../controls/Icon';

/** Rows drawn at once: a filter finds the others. */
const kMostRows = 200;

export function ImportReport({ report }: { report: Import }) {
  const filter = useSignal<ReportFilter>({ fate: '', piece: '', text: '' });
  const accounts = accountsOf(report.report);
  const entities = entitiesShown(report.report.entities, filter.value);
  const warnings = warningsShown(report.report.warnings, filter.value);
  const set = (part: Partial<ReportFilter>): void => void (filter.value = { ...filter.value, ...part });
  return (
    <section class="import-report" aria-label="Import report">
      <p class="accounts">
        {accounts.sum}.{' '}
        {accounts.whole ? (
          <span class="good">Every one is accounted for.</span>
        ) : (
          <span class="warn">The parts do not sum to the file.</span>
        )}
      </p>
      <Fates accounts={accounts} chosen={filter.value.fate} choose={(fate) => set({ fate })} />
      <Filter report={report} filter={filter.value} set={set} />
      <Warnings warnings={warnings} />
      <Entities entities={entities} />
      {entities.length === 0 && warnings.length === 0 && <p class="hint">Nothing of that kind.</p>}
      {entities.length > kMostRows && (
        <p class="hint">{counted(entities.length - kMostRows, 'more group')} match; search for them.</p>
      )}
    </section>
  );
}

interface FatesProps {
  accounts: Accounts;
  chosen: ReportFilter['fate'];
  choose(fate: ReportFilter['fate']): void;
}

/** How many entities had which fate; a click shows those alone. */
function Fates({ accounts, chosen, choose }: FatesProps) {
  return (
    <div class="fates" role="radiogroup" aria-label="Show">
      {[{ fate: '' as const, count: accounts.entities }, ...accounts.shares].map((share) => (
        <button
          key={share.fate}
          role="radio"
          class={`fate-${share.fate || 'all'}`}
          aria-checked={chosen === share.fate}
          onClick={() => choose(share.fate)}
        >
          <b>{count(share.count)}</b> {share.fate || 'all'}
        </button>
      ))}
    </div>
  );
}

interface FilterProps {
  report: Import;
  filter: ReportFilter;
  set(part: Partial<ReportFilter>): void;
}

function Filter({ report, filter, set }: FilterProps) {
  const { imports } = useCommands();
  return (
    <div class="report-filter">
      <label class="text-field">
        <span class="visually-hidden">Search in the report</span>
        <input
          type="search"
          placeholder="Search layer, kind, reason…"
          value={filter.text}
          onInput={(event) => set({ text: event.currentTarget.value })}
        />
      </label>
      <label class="select-field">
        <span class="visually-hidden">Piece</span>
        <select value={filter.piece} onChange={(event) => set({ piece: event.currentTarget.value })}>
          <option value="">All pieces</option>
          {report.pieces.map((piece) => (
            <option key={piece.name} value={piece.name}>
              {piece.name}
            </option>
          ))}
        </select>
      </label>
      <button class="link" onClick={() => imports.saveReport()}>
        Save as JSON
      </button>
    </div>
  );
}

/** What is known of a thing, in a row; what is not known is left away. */
const said = (parts: readonly (string | false | null)[]): string => parts.filter(Boolean).join(' · ');

function Warnings({ warnings }: { warnings: readonly ImportWarning[] }) {
  if (warnings.length === 0) return null;
  return (
    <ul class="warnings" aria-label="Warnings">
      {warnings.slice(0, kMostRows).map((one, i) => (
        <li key={i}>
          <Icon name="alert" />
          <div>
            <p>{sentence(one.text)}</p>
            <small>
              {said([
                one.piece && `piece ${one.piece}`,
                one.at && `at ${one.at[0].toFixed(0)}, ${one.at[1].toFixed(0)} mm`,
                one.line > 0 && `line ${one.line}`,
                one.count > 1 && `${count(one.count)} times`,
              ])}
            </small>
          </div>
        </li>
      ))}
    </ul>
  );
}

function Entities({ entities }: { entities: readonly ImportedEntity[] }) {
  return (
    <ul class="entities" aria-label="Entities">
      {entities.slice(0, kMostRows).map((one, i) => (
        <li key={i} class={`fate-${one.fate}`}>
          <em>{one.fate}</em>
          <div>
            <p>
              <b>
                {one.count > 1 && `${count(one.count)} × `}
                {one.type}
              </b>{' '}
              {one.layer && `on layer ${one.layer}`}
            </p>
            {one.reason && <p>{sentence(one.reason)}</p>}
            <small>
              {said([one.piece && `piece ${one.piece}`, one.block && `block ${one.block}`, linesText(one.lines)])}
            </small>
          </div>
        </li>
      ))}
    </ul>
  );
}
