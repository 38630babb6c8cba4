// What came of a drape: stills, the report in words, files to take along.

import { useSignal } from '@preact/signals';
import { loading, valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { isActive } from '../state/jobs';
import { downloadsOf, reportLines, stillsOf } from '../state/report';
import { seamTitle } from '../state/seamNames';
import { CompareWith } from './CompareWith';
import { Enlarged, FileLink, Lines, stillName, Stills } from './DrapeParts';
import { FitTable } from './FitTable';
import { Movies, type MovieMaking } from './Movies';
import { Pictures, type PictureTaking } from './Pictures';
import { OutcomeList } from './OutcomeList';
import type { PicturesProps } from './Rail';
import { SectionPanel } from './SectionPanel';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

export function Results({ resultUrl, movies }: PicturesProps & { movies?: MovieMaking & PictureTaking }) {
  const state = useAppState();
  const job = state.job.value;
  const large = useSignal<string | null>(null);
  if (!job) return <p class="hint">{t.report.nothingYet}</p>;
  const results = job.results ?? {};
  const stills = stillsOf(results);
  const downloads = downloadsOf(results);
  if (isActive(job.state) && downloads.length === 0) {
    return <p class="hint">{t.report.keptHere}</p>;
  }
  const urlOf = (name: string, width?: number): string => resultUrl(job.id, name, width);
  return (
    <>
      <OutcomeList />
      {stills.length > 0 && <Stills names={stills} urlOf={urlOf} enlarge={(name) => (large.value = name)} />}
      <Report />
      <Fit />
      <SectionPanel />
      <CompareWith job={job} />
      <Pictures job={job} taking={movies} />
      <Movies job={job} making={movies} />
      {downloads.length > 0 && <h3>{t.common.takeOut}</h3>}
      <ul class="downloads">
        {downloads.map((file) => (
          <FileLink key={file.name} file={file} url={urlOf(file.name)} of={job.name} tip={file.name} />
        ))}
        {stills.map((name) => {
          const file = { name, title: 'PNG', hint: t.report.still(stillName(name)), bytes: results[name]! };
          return <FileLink key={name} file={file} url={urlOf(name)} of={job.name} />;
        })}
      </ul>
      {downloads.length === 0 && stills.length === 0 && <p class="hint">{t.report.withoutResults}</p>}
      {large.value && (
        <Enlarged url={urlOf(large.value)} name={stillName(large.value)} close={() => (large.value = null)} />
      )}
    </>
  );
}

function Fit() {
  const report = valueOf(useAppState().report.value ?? loading);
  return report && <FitTable report={report} />;
}

function Report() {
  const state = useAppState();
  const report = state.report.value;
  if (report?.state === 'loading')
    return (
      <p class="hint" role="status">
        {t.report.reading}
      </p>
    );
  if (report?.state === 'failed')
    return (
      <p class="hint bad">
        <Told code={report.error.code} detail={report.error.detail} /> <span class="code">{report.error.code}</span>
      </p>
    );
  if (!report) return null;
  return <Lines lines={reportLines(report.value, (id) => seamTitle(state.sewn.value, id))} />;
}
