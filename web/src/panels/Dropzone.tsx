// Where files are chosen; the whole page takes those that are dropped.

import { useRef } from 'preact/hooks';
import { acceptOf, kPictureEndings } from '../api/formats';
import { useCommands } from '../commands/context';
import { Icon } from '../controls/Icon';
import { useAppState } from '../state/context';
import { t } from '../texts/language';

export function Dropzone({ title, focused = false }: { title: string; focused?: boolean }) {
  const { dressing } = useAppState();
  const commands = useCommands();
  const input = useRef<HTMLInputElement>(null);
  const take = (list: FileList | null): void =>
    void commands.intake.addFiles([...(list ?? [])].map((file) => ({ name: file.name, blob: file })));
  return (
    <>
      <button class="dropzone" autofocus={focused} onClick={() => input.current?.click()}>
        <Icon name="file" />
        <b>{title}</b>
        <small>{t.intake.takes}</small>
      </button>
      <input
        ref={input}
        type="file"
        multiple
        hidden
        accept={acceptOf(dressing.meshEndings.value, '.json', '.dxf', ...kPictureEndings)}
        onChange={(event) => {
          take(event.currentTarget.files);
          event.currentTarget.value = '';
        }}
      />
    </>
  );
}
