// The whole page takes dropped files.

import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { useCommands } from '../commands/context';
import { Icon } from '../controls/Icon';
import { t } from '../texts/language';

const carriesFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;

export function DropTarget() {
  const commands = useCommands();
  const over = useSignal(false);
  useEffect(() => {
    const enter = (event: DragEvent): void => {
      if (!carriesFiles(event)) return;
      event.preventDefault();
      over.value = true;
    };
    const leave = (event: DragEvent): void => {
      if (event.relatedTarget === null) over.value = false;
    };
    const drop = (event: DragEvent): void => {
      if (!carriesFiles(event)) return;
      event.preventDefault();
      over.value = false;
      void commands.intake.addFiles([...event.dataTransfer!.files].map((file) => ({ name: file.name, blob: file })));
    };
    const listeners = [
      ['dragenter', enter],
      ['dragover', enter],
      ['dragleave', leave],
      ['drop', drop],
    ] as const;
    for (const [name, listener] of listeners) window.addEventListener(name, listener);
    return () => listeners.forEach(([name, listener]) => window.removeEventListener(name, listener));
  }, [commands, over]);
  return over.value ? (
    <div class="drop-veil" aria-hidden="true">
      <div>
        <Icon name="file" />
        <b>{t.intake.dropToMake}</b>
        <small>{t.intake.dropWhat}</small>
      </div>
    </div>
  ) : null;
}
