// The figures of two drapes in one table, what differs in bold.

import { apart, comparedOf, comparisonRows } from '../state/comparison';
import { useAppState } from '../state/context';
import { millimetres } from '../state/words';
import { t } from '../texts/language';

/** Null until both are there. */
export function ComparisonPanel() {
  const { comparison, dressing } = useAppState();
  const [left, right] = [comparedOf(comparison.left.value), comparedOf(comparison.right.value)];
  if (!left || !right) return null;
  const rows = comparisonRows(left.report, right.report, dressing.unit.value);
  const moved = apart(left, right);
  return (
    <section class="comparison" aria-label={t.report.compared.both}>
      <table>
        <thead>
          <tr>
            <th scope="col">{t.report.compared.figure}</th>
            {[left, right].map(({ job }) => (
              <th key={job.id} scope="col">
                {job.name}, {t.frame.revision(job.project_revision)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <tr key={row.title} class={row.differs ? 'differs' : ''}>
              <th scope="row">{row.title}</th>
              <td>{row.left}</td>
              <td>{row.right}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p>
        {moved === null
          ? t.report.compared.otherMesh
          : t.report.compared.sameMesh(millimetres(moved))}
      </p>
    </section>
  );
}
