// Girths of body and garment with the ease between, as a tailor would note them down.

import type { Report } from '../api/types';
import { useAppState } from '../state/context';
import { fitRows, type FitRow } from '../state/fit';

/** Null where nothing goes around anybody. */
export function FitTable({ report }: { report: Pick<Report, 'fit'> }) {
  const { dressing } = useAppState();
  const rows = fitRows(report, dressing.unit.value);
  if (rows.length === 0) return null;
  return (
    <>
      <h3>Fit</h3>
      <table class="fit">
        <thead>
          <tr>
            <th scope="col">Girth</th>
            <th scope="col">Body</th>
            <th scope="col">Garment</th>
            <th scope="col">Ease</th>
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
        {row.word !== 'fits' && <small>{row.word}</small>}
      </th>
      <td>{row.body}</td>
      <td>{row.garment}</td>
      <td>
        <b>{row.ease}</b>
      </td>
    </tr>
  );
}
