import { useEffect, useRef } from 'preact/hooks';
import { bindings } from '../tools/keys';
import { useAppState } from '../state/context';
import { Icon } from '../controls/Icon';

/** The keys, from the table that handles them. */
export function HelpDialog() {
  const state = useAppState();
  return state.helpShown.value ? <Dialog close={() => (state.helpShown.value = false)} /> : null;
}

const kMouse: [string, string][] = [
  ['Drag', 'Turn the view'],
  ['Right drag', 'Move the view'],
  ['Wheel', 'Nearer, further'],
  ['Click', 'Select a piece or seam'],
  ['Middle drag', 'Move the pattern'],
  ['Double click', 'New point on an edge (Z)'],
  ['Shift drag', 'In steps of 45°'],
];

function Dialog({ close }: { close: () => void }) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => dialog.current?.showModal(), []);
  const groups = [...new Set(bindings.map((binding) => binding.group))];
  return (
    <dialog class="sheet help" ref={dialog} onClose={close} aria-labelledby="help-title">
      <header>
        <h2 id="help-title">Keys and mouse</h2>
        <button class="tool flat" aria-label="Close" onClick={() => dialog.current?.close()}>
          <Icon name="cross" />
        </button>
      </header>
      <div class="sheet-body keys">
        {groups.map((group) => (
          <section key={group}>
            <h3>{group}</h3>
            <dl>
              {bindings
                .filter((binding) => binding.group === group)
                .map((binding) => (
                  <div key={binding.shown}>
                    <dt>
                      <kbd>{binding.shown}</kbd>
                    </dt>
                    <dd>{binding.title}</dd>
                  </div>
                ))}
            </dl>
          </section>
        ))}
        <section>
          <h3>Mouse</h3>
          <dl>
            {kMouse.map(([press, title]) => (
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
    </dialog>
  );
}
