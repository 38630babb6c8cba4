// What came of a drape: stills, the report in words, files to take along.

import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { useAppState } from '../state/context';
import { isActive } from '../state/jobs';
import { downloadsOf, reportLines, stillsOf } from '../state/report';
import { bytes } from '../state/words';
import { Icon } from './Icon';
import type { PicturesProps } from './Rail';

const kStillNames: Record<string, string> = {
  'three-quarter.png': 'Three-quarter',
  'front.png': 'Front',
  'back.png': 'Back',
  'side.png': 'Side',
};

export function Results({ resultUrl }: PicturesProps) {
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
  return (
    <>
      {stills.length > 0 && (
        <ul class="stills">
          {stills.map((name) => (
            <li key={name}>
              <button onClick={() => (large.value = name)} aria-label={`${kStillNames[name] ?? name} still, enlarge`}>
                <img src={resultUrl(job.id, name)} alt="" decoding="async" />
                <span>{kStillNames[name] ?? name}</span>
              </button>
            </li>
          ))}
        </ul>
      )}
      <Report />
      {downloads.length > 0 && <h3>Take out</h3>}
      <ul class="downloads">
        {downloads.map((file) => (
          <li key={file.name}>
            <a href={resultUrl(job.id, file.name)} download={`${job.name} ${file.name}`} title={file.name}>
              <Icon name="down" />
              <span>
                <b>{file.title}</b>
                {file.hint && <small>{file.hint}</small>}
              </span>
              <em>{bytes(file.bytes)}</em>
            </a>
          </li>
        ))}
        {stills.map((name) => (
          <li key={name}>
            <a href={resultUrl(job.id, name)} download={`${job.name} ${name}`}>
              <Icon name="down" />
              <span>
                <b>PNG</b>
                <small>{kStillNames[name] ?? name} still</small>
              </span>
              <em>{bytes(results[name]!)}</em>
            </a>
          </li>
        ))}
      </ul>
      {downloads.length === 0 && stills.length === 0 && <p class="hint">This drape ended without results.</p>}
      {large.value && (
        <Enlarged
          url={resultUrl(job.id, large.value)}
          name={kStillNames[large.value] ?? large.value}
          close={() => (large.value = null)}
        />
      )}
    </>
  );
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
  return (
    <ul class="report">
      {reportLines(report.value).map((line) => (
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
