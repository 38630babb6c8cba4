// What the look before a drape found: what it is, the way out, and where. A click flies there.

import type { Finding } from '../api/dressing';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { aboutText, findingCounts, sortedFindings } from '../state/dressing';
import { Icon, type IconName } from '../controls/Icon';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

const kIcons: Record<Finding['severity'], IconName> = { error: 'cross', warning: 'alert', note: 'help' };


export function ProblemList() {
  const { dressing } = useAppState();
  const check = dressing.check.value;
  const problem = dressing.startProblem.value;
  if (problem) {
    return (
      <div class="problem" role="alert">
        <Icon name="alert" />
        <div>
          <p>
            <Told code={problem.code} detail={problem.detail} />
          </p>
          {problem.where && <p class="where">{problem.where}</p>}
        </div>
      </div>
    );
  }
  if (!check) {
    return (
      <p class="busy" role="status">
        <span class="spinner" aria-hidden="true" /> {t.arrange.looking}
      </p>
    );
  }
  const findings = sortedFindings(check.findings);
  const open = findings.filter((finding) => !finding.repaired && finding.severity !== 'note');
  const rest = findings.filter((finding) => !open.includes(finding));
  const shown = dressing.finding.value?.finding;
  return (
    <section class="findings" aria-label={t.arrange.problems}>
      <Verdict ready={check.ready} findings={check.findings} />
      <Rows findings={open} />
      {rest.length > 0 && (
        <details open={shown !== undefined && rest.includes(shown)}>
          <summary>{t.arrange.goodToKnow(rest.length)}</summary>
          <Rows findings={rest} />
        </details>
      )}
    </section>
  );
}

const Rows = ({ findings }: { findings: Finding[] }) => (
  <ul>
    {findings.map((finding, i) => (
      <Row key={`${finding.code} ${finding.where} ${i}`} finding={finding} />
    ))}
  </ul>
);

/** One line that says whether the drape can begin. */
function Verdict({ ready, findings }: { ready: boolean; findings: Finding[] }) {
  const counts = findingCounts(findings);
  const parts = [
    counts.error && t.arrange.errors(counts.error),
    counts.warning && t.arrange.warnings(counts.warning),
    counts.note && t.arrange.notes(counts.note),
    counts.repaired && t.arrange.repaired(counts.repaired),
  ].filter(Boolean);
  return (
    <p class={`verdict ${ready ? (counts.warning ? 'warn' : 'good') : 'bad'}`}>
      <Icon name={ready ? 'check' : 'cross'} />
      <b>{ready ? t.arrange.ready : t.arrange.notReady}</b>
      <small>{parts.join(', ') || t.arrange.noFault}</small>
    </p>
  );
}

function Row({ finding }: { finding: Finding }) {
  const { dressing, sewn } = useAppState();
  const commands = useCommands();
  const shown = dressing.finding.value?.finding === finding;
  const kind = finding.repaired ? 'repaired' : finding.severity;
  return (
    <li>
      <button class={`finding ${kind}`} aria-pressed={shown} onClick={() => commands.dressing.look(finding)}>
        <Icon name={finding.repaired ? 'check' : kIcons[finding.severity]} />
        <span>
          <em>{finding.repaired ? t.arrange.severities.repaired : t.arrange.severities[finding.severity]}</em> <Told code={finding.code} detail={finding.message} />
          <small>{aboutText(finding, sewn.value) || finding.where}</small>
        </span>
      </button>
    </li>
  );
}
