// What came of a drape: stills, the report in words, files to take along.

import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { loading, valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { isActive } from '../state/jobs';
import { downloadsOf, reportLines, stillsOf, type Download } from '../state/report';
import { seamTitle } from '../state/seamView';
import { bytes } from '../state/words';
import { Icon } from '../controls/Icon';
import { CompareWith } from './CompareWith';
import { FitTable } from './FitTable';
import { Movies, type MovieMaking } from './Movies';
import { OutcomeList } from './OutcomeList';
import type { PicturesProps } from './Rail';

const kStillNames: Record<string, string> = {
  'three-quarter.png': 'Three-quarter',
  'front.png': 'Front',
  'back.png': 'Back',
  'side.png': 'Side',
};

/** Of the pictures in a row, pixels; a click shows the whole one. */
const kStillWidth = 320;

const stillName = (name: string): string => kStillNames[name] ?? name;

export function Results({ resultUrl, movies }: PicturesProps & { movies?: MovieMaking }) {
  const state = useAppState();
  const job = state.job.value;
  const large = useSignal<string | null>(null);
  if (!job) return <p class="hint">Nothing has been draped yet.</p>;
  const results = job.results ?? {};
  const stills = stillsOf(results);
  const downloads = downloadsOf(results);
  if (isActive(job.state) && downloads.length === 0) {
    return <p class="hint">Stills, models and the report are kept here when the drape has ended.</p>;
  }
  const urlOf = (name: string, width?: number): string => resultUrl(job.id, name, width);
  return (
    <>
      <OutcomeList />
      {stills.length > 0 && <Stills names={stills} urlOf={urlOf} enlarge={(name) => (large.value = name)} />}
      <Report />
      <Fit />
      <CompareWith job={job} />
      <Movies job={job} making={movies} />
      {downloads.length > 0 && <h3>Take out</h3>}
      <ul class="downloads">
        {downloads.map((file) => (
          <FileLink key={file.name} file={file} url={urlOf(file.name)} of={job.name} tip={file.name} />
        ))}
        {stills.map((name) => {
          const file = { name, title: 'PNG', hint: `${stillName(name)} still`, bytes: results[name]! };
          return <FileLink key={name} file={file} url={urlOf(name)} of={job.name} />;
        })}
      </ul>
      {downloads.length === 0 && stills.length === 0 && <p class="hint">This drape ended without results.</p>}
      {large.value && (
        <Enlarged url={urlOf(large.value)} name={stillName(large.value)} close={() => (large.value = null)} />
      )}
    </>
  );
}

interface StillsProps {
  names: readonly string[];
  urlOf(name: string, width?: number): string;
  enlarge(name: string): void;
}

function Stills({ names, urlOf, enlarge }: StillsProps) {
  return (
    <ul class="stills">
      {names.map((name) => (
        <li key={name}>
          <button onClick={() => enlarge(name)} aria-label={`${stillName(name)} still, enlarge`}>
            <img src={urlOf(name, kStillWidth)} alt="" decoding="async" />
            <span>{stillName(name)}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}

/** A file to take along; it is saved under the drape's name. */
function FileLink({ file, url, of, tip }: { file: Download; url: string; of: string; tip?: string }) {
  return (
    <li>
      <a href={url} download={`${of} ${file.name}`} title={tip}>
        <Icon name="down" />
        <span>
          <b>{file.title}</b>
          {file.hint && <small>{file.hint}</small>}
        </span>
        <em>{bytes(file.bytes)}</em>
      </a>
    </li>
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
        Reading the report…
      </p>
    );
  if (report?.state === 'failed')
    return (
      <p class="hint bad">
        {report.error.detail} <span class="code">{report.error.code}</span>
      </p>
    );
  if (!report) return null;
  const seams = valueOf(state.pieces.value ?? loading)?.seams ?? [];
  return (
    <ul class="report">
      {reportLines(report.value, (id) => seamTitle(seams, id)).map((line) => (
        <li key={line.label} class={`verdict-${line.verdict}`}>
          <Icon name={line.verdict === 'warn' ? 'alert' : 'check'} />
          <div>
            <p>
              <span>{line.label}</span>
              <b>{line.value}</b>
            </p>
            <small>{line.sentence}</small>
          </div>
        </li>
      ))}
    </ul>
  );
}

function Enlarged({ url, name, close }: { url: string; name: string; close: () => void }) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => dialog.current?.showModal(), []);
  return (
    <dialog class="enlarged" ref={dialog} onClose={close} onClick={close} aria-label={`${name} still`}>
      <img src={url} alt={`${name} view of the draped garment`} />
      <button class="tool" aria-label="Close" onClick={close}>
        <Icon name="cross" />
      </button>
    </dialog>
  );
}
