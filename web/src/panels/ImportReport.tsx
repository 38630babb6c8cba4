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
import { count } from '../state/words';
import { patternFigure, patternLength } from '../texts/units';
import { Icon } from '../controls/Icon';
import { t } from '../texts/language';
import { Said } from '../texts/Message';
import { asRead } from '../texts/told';

/** Rows drawn at once: a filter finds the others. */
const kMostRows = 200;

export function ImportReport({ report }: { report: Import }) {
  const filter = useSignal<ReportFilter>({ fate: '', piece: '', text: '' });
  const accounts = accountsOf(report.report);
  const entities = entitiesShown(report.report.entities, filter.value);
  const warnings = warningsShown(report.report.warnings, filter.value);
  const set = (part: Partial<ReportFilter>): void => void (filter.value = { ...filter.value, ...part });
  return (
    <section class="import-report" aria-label={t.imports.reportTitle}>
      <p class="accounts">
        {accounts.sum}.{' '}
        {accounts.whole ? (
          <span class="good">{t.imports.accounted}</span>
        ) : (
          <span class="warn">{t.imports.unaccounted}</span>
        )}
      </p>
      <Fates accounts={accounts} chosen={filter.value.fate} choose={(fate) => set({ fate })} />
      <Filter report={report} filter={filter.value} set={set} />
      <Warnings warnings={warnings} />
      <Entities entities={entities} />
      {entities.length === 0 && warnings.length === 0 && <p class="hint">{t.imports.noneOfKind}</p>}
      {entities.length > kMostRows && (
        <p class="hint">{t.imports.moreGroups(entities.length - kMostRows)}</p>
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
    <div class="fates" role="radiogroup" aria-label={t.imports.show}>
      {[{ fate: '' as const, count: accounts.entities }, ...accounts.shares].map((share) => (
        <button
          key={share.fate}
          role="radio"
          class={`fate-${share.fate || 'all'}`}
          aria-checked={chosen === share.fate}
          onClick={() => choose(share.fate)}
        >
          <b>{count(share.count)}</b> {t.imports.fates[share.fate || 'all']}
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
        <span class="visually-hidden">{t.imports.search}</span>
        <input
          type="search"
          placeholder={t.imports.searchWhat}
          value={filter.text}
          onInput={(event) => set({ text: event.currentTarget.value })}
        />
      </label>
      <label class="select-field">
        <span class="visually-hidden">{t.common.piece}</span>
        <select value={filter.piece} onChange={(event) => set({ piece: event.currentTarget.value })}>
          <option value="">{t.imports.allPieces}</option>
          {report.pieces.map((piece) => (
            <option key={piece.name} value={piece.name}>
              {piece.name}
            </option>
          ))}
        </select>
      </label>
      <button class="link" onClick={() => imports.saveReport()}>
        {t.imports.saveJson}
      </button>
    </div>
  );
}

/** What is known of a thing, in a row; what is not known is left away. */
const said = (parts: readonly (string | false | null)[]): string => parts.filter(Boolean).join(' · ');

function Warnings({ warnings }: { warnings: readonly ImportWarning[] }) {
  if (warnings.length === 0) return null;
  return (
    <ul class="warnings" aria-label={t.imports.warnings}>
      {warnings.slice(0, kMostRows).map((one, i) => (
        <li key={i}>
          <Icon name="alert" />
          <div>
            <p>
              <Said text={one.text} />
            </p>
            <small>
              {said([
                one.piece && t.imports.pieceOf(one.piece),
                one.at && t.imports.placeAt(`${patternFigure(one.at[0], 0)}, ${patternLength(one.at[1], 0)}`),
                one.line > 0 && t.imports.lineAt(one.line),
                one.count > 1 && t.imports.times(count(one.count)),
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
    <ul class="entities" aria-label={t.imports.entities}>
      {entities.slice(0, kMostRows).map((one, i) => (
        <li key={i} class={`fate-${one.fate}`}>
          <em>{t.imports.fates[one.fate]}</em>
          <div>
            <p>
              <b>
                {one.count > 1 && `${count(one.count)} × `}
                {asRead(one.type)}
              </b>{' '}
              {one.layer && t.imports.onLayer(one.layer)}
            </p>
            {one.reason && (
              <p>
                <Said text={one.reason} />
              </p>
            )}
            <small>
              {said([one.piece && t.imports.pieceOf(one.piece), one.block && t.imports.blockOf(one.block), linesText(one.lines)])}
            </small>
          </div>
        </li>
      ))}
    </ul>
  );
}
