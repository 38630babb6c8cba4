// Files become a project: shows what was given, what is missing and the way on.

import { useSignal } from '@preact/signals';
import { useCommands } from '../commands/context';
import type { Intake } from '../state/AppState';
import { useAppState } from '../state/context';
import type { IntakePlan } from '../state/intake';
import { valueOf } from '../state/AppState';
import { documentOf, type ImportDraft } from '../state/importDraft';
import { bytes } from '../state/words';
import { Icon } from '../controls/Icon';
import { Sheet } from '../controls/Sheet';
import { Dropzone } from './Dropzone';
import { ImportPanel, type PreviewSlot } from './ImportPanel';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

export function IntakeDialog({ Preview }: PreviewSlot) {
  const state = useAppState();
  return state.intake.value ? <Dialog intake={state.intake.value} Preview={Preview} /> : null;
}

function Dialog({ intake, Preview }: { intake: Intake } & PreviewSlot) {
  const commands = useCommands();
  const warned = useSignal(false);
  const state = useAppState();
  const { plan, error } = intake;
  const draft = state.importing.value;
  // What was decided of a file would be lost: the first Escape only says so.
  const mayLeave = (): boolean => {
    const may = !draft || warned.value;
    warned.value = !may;
    return may;
  };
  return (
    <Sheet
      class={`intake${draft ? ' wide' : ''}`}
      id="intake-title"
      title={draft ? t.intake.newFrom(draft.source.file.name) : t.common.newProject}
      close={() => commands.intake.close()}
      mayLeave={mayLeave}
    >
      <div class="sheet-body">
        <Dropzone title={intake.files.length === 0 ? t.intake.dropHere : t.intake.addMore} focused />
        <Given intake={intake} />
        {plan && <Missing plan={plan} />}
        {draft && <ImportPanel draft={draft} Preview={Preview} />}
        {error && <Problem text={error.detail} code={error.code} where={error.where} />}
      </div>
      <Makers intake={intake} draft={draft} hint={warned.value ? t.intake.leaving : ''} />
    </Sheet>
  );
}

interface ProblemProps {
  text: string;
  code: string;
  where: string;
  /** The page's own words, which need no others. */
  own?: boolean;
}

function Problem({ text, code, where, own = false }: ProblemProps) {
  return (
    <div class="problem" role="alert">
      <Icon name="alert" />
      <div>
        <p>{own ? text : <Told code={code} detail={text} />}</p>
        <p class="code">{[code, where].filter(Boolean).join(' · ')}</p>
      </div>
    </div>
  );
}

/** Whether a project can be made of what is there. */
function isWhole(intake: Intake, draft: ImportDraft | null): boolean {
  if (!draft) return intake.plan?.ready ?? false;
  const report = valueOf(draft.report);
  return report !== null && !draft.rereading && documentOf(draft, report, null) !== null;
}

/** The way on, and what is being done. */
function Makers({ intake, draft, hint }: { intake: Intake; draft: ImportDraft | null; hint: string }) {
  const commands = useCommands();
  const make = (drape: boolean): void => void (draft ? commands.imports.make(drape) : commands.intake.createProject(drape));
  const stuck = !isWhole(intake, draft) || intake.busy !== '';
  return (
    <footer>
      <span class="busy" role="status">
        {intake.busy && (
          <>
            <span class="spinner" aria-hidden="true" />
            {intake.busy}…
          </>
        )}
        {!intake.busy && hint}
      </span>
      <button class="plain" disabled={stuck} onClick={() => make(false)}>
        {t.intake.create}
      </button>
      <button class="primary" disabled={stuck} onClick={() => make(true)}>
        <Icon name="play" /> {t.intake.createAndDrape}
      </button>
    </footer>
  );
}

function Given({ intake }: { intake: Intake }) {
  const commands = useCommands();
  const { plan } = intake;
  if (intake.files.length === 0) return null;
  const role = (name: string): string => {
    if (!plan) return '';
    if (plan.documentName === name) return t.intake.roles.project;
    const need = plan.needed.find((one) => one.file?.name === name);
    if (need) return { dxf: t.intake.roles.pattern, body: t.intake.roles.body, image: t.intake.roles.image }[need.kind];
    if (plan.loose?.file.name === name) return t.intake.roles.pattern;
    if (plan.loose?.bodies.some((body) => body.name === name)) return t.intake.roles.body;
    return plan.unused.includes(name) ? t.intake.roles.unused : '';
  };
  return (
    <ul class="files">
      {intake.files.map((file) => (
        <li key={file.name} class={plan?.unused.includes(file.name) ? 'unused' : ''}>
          <Icon name="file" />
          <b>{file.name}</b>
          <small>{role(file.name)}</small>
          <em>{bytes(file.blob.size)}</em>
          <button
            class="tool flat"
            aria-label={t.frame.remove(file.name)}
            onClick={() => void commands.intake.removeFile(file.name)}
          >
            <Icon name="cross" />
          </button>
        </li>
      ))}
    </ul>
  );
}

function Missing({ plan }: { plan: IntakePlan }) {
  const missing = plan.needed.filter((need) => need.file === null);
  return (
    <>
      {plan.problems.map((problem, i) => (
        <Problem key={i} text={problem.text} code={problem.code} where={problem.where} own />
      ))}
      {missing.length > 0 && (
        <div class="missing" role="status">
          <p>
            <b>{plan.name}</b> {t.intake.alsoNeeds(missing.length)}
          </p>
          <ul>
            {missing.map((need) => (
              <li key={need.name}>
                <code>{need.name}</code> {need.kind === 'dxf' ? t.intake.thePattern : t.intake.theBody}
              </li>
            ))}
          </ul>
          <p>{t.intake.besides}</p>
        </div>
      )}
      {plan.ready && (
        <p class="complete">
          <Icon name="check" /> {t.intake.complete}
        </p>
      )}
    </>
  );
}
