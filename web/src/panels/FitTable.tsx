// Girths of body and garment with the ease between, as a tailor would note them down.

import type { Report } from '../api/types';
import { useAppState } from '../state/context';
import { fitRows, type FitRow } from '../state/fit';
import { t } from '../texts/language';

/** Null where nothing goes around anybody. */
export function FitTable({ report }: { report: Pick<Report, 'fit'> }) {
  const { dressing } = useAppState();
  const rows = fitRows(report, dressing.unit.value);
  if (rows.length === 0) return null;
  return (
    <>
      <h3>{t.report.fit.title}</h3>
      <table class="fit">
        <thead>
          <tr>
            <th scope="col">{t.report.fit.girth}</th>
            <th scope="col">{t.report.fit.body}</th>
            <th scope="col">{t.report.fit.garment}</th>
            <th scope="col">{t.report.fit.ease}</th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <Row key={row.at} row={row} />
          ))}
        </tbody>
      </table>
    </>
  );
}

function Row({ row }: { row: FitRow }) {
  return (
    <tr class={`verdict-${row.verdict}`} title={row.hint}>
      <th scope="row">
        {row.title}
        {row.fit !== 'fits' && <small>{row.word}</small>}
      </th>
      <td>{row.body}</td>
      <td>{row.garment}</td>
      <td>
        <b>{row.ease}</b>
      </td>
    </tr>
  );
}
