import { bindings, shownKey } from '../tools/keys';
import { useAppState } from '../state/context';
import { Sheet } from '../controls/Sheet';
import { TourButton } from './TourButton';
import { t } from '../texts/language';

/** The keys, from the table that handles them. */
export function HelpDialog() {
  const state = useAppState();
  return state.helpShown.value ? <Dialog close={() => (state.helpShown.value = false)} /> : null;
}

const mouse = (): [string, string][] => [
  [t.keys.mouse.drag, t.keys.mouse.dragDoes],
  [t.keys.mouse.right, t.keys.mouse.rightDoes],
  [t.keys.mouse.wheel, t.keys.mouse.wheelDoes],
  [t.keys.mouse.click, t.keys.mouse.clickDoes],
  [t.keys.mouse.middle, t.keys.mouse.middleDoes],
  [t.keys.mouse.double, t.keys.mouse.doubleDoes],
  [t.keys.mouse.shift, t.keys.mouse.shiftDoes],
];

function Dialog({ close }: { close: () => void }) {
  const groups = [...new Set(bindings.map((binding) => binding.group))];
  return (
    <Sheet class="help" id="help-title" title={t.keys.title} beside={<TourButton />} close={close}>
      <div class="sheet-body keys" tabIndex={0}>
        {groups.map((group) => (
          <section key={group}>
            <h3>{t.keys.groups[group]}</h3>
            <dl>
              {bindings
                .filter((binding) => binding.group === group)
                .map((binding) => (
                  <div key={binding.shown}>
                    <dt>
                      <kbd>{shownKey(binding)}</kbd>
                    </dt>
                    <dd>{binding.title()}</dd>
                  </div>
                ))}
            </dl>
          </section>
        ))}
        <section>
          <h3>{t.keys.mouseTitle}</h3>
          <dl>
            {mouse().map(([press, title]) => (
              <div key={press}>
                <dt>
                  <kbd>{press}</kbd>
                </dt>
                <dd>{title}</dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
    </Sheet>
  );
}
