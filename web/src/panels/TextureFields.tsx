// The picture on a piece, or on all of them: which one, how large, where and how it is turned.

import { useEffect, useRef } from 'preact/hooks';
import { kPictureEndings } from '../api/formats';
import type { Piece, Texture } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { commonTexture } from '../state/texture';
import { NumberField } from '../controls/NumberField';
import { t } from '../texts/language';

/** What a browser can show and the service reads. */
const kAccepted = ['image/png', 'image/jpeg', ...kPictureEndings].join(',');

export function TextureFields({ pieces, all }: { pieces: readonly Piece[]; all: readonly Piece[] }) {
  const { textures } = useCommands();
  const ids = pieces.map((piece) => piece.id);
  const texture = commonTexture(pieces);
  const shown = texture === 'mixed' ? null : texture;
  const elsewhere = shown !== null && pieces.length < all.length && commonTexture(all) === 'mixed';
  return (
    <section class="texture" aria-label={pieces.length === 1 ? t.fabric.onPiece : t.fabric.onAll}>
      <h3>
        {pieces.length === 1 ? t.fabric.picture : t.fabric.onAll}
        {texture === 'mixed' && <span class="head-note">{t.fabric.differ}</span>}
      </h3>
      <ImageChoice ids={ids} piece={pieces[0]!} texture={texture} />
      {shown && <Lie ids={ids} texture={shown} />}
      <div class="button-row">
        {elsewhere && (
          <button class="plain" onClick={() => void textures.onAll(shown)}>
            {t.fabric.sameOnAll}
          </button>
        )}
        {texture !== null && (
          <button class="plain" onClick={() => void textures.takeOff(ids)}>
            {t.fabric.takeOff}
          </button>
        )}
      </div>
    </section>
  );
}

interface ImageChoiceProps {
  ids: string[];
  piece: Piece;
  texture: Texture | null | 'mixed';
}

function ImageChoice({ ids, piece, texture }: ImageChoiceProps) {
  const state = useAppState();
  const { textures } = useCommands();
  const input = useRef<HTMLInputElement>(null);
  useEffect(() => void textures.loadImages(), [textures]);
  const images = state.editing.images.value;
  const now = texture === 'mixed' || texture === null ? undefined : state.project.value?.files[texture.image];
  const look = now === undefined ? undefined : state.looks.value.get(piece.id);
  const choose = (id: string): void => {
    const image = images.find((one) => one.id === id);
    if (image) void textures.putOn(ids, image);
  };
  return (
    <div class="texture-choice">
      {look && <img src={look.picture.url} alt="" width={40} height={40} />}
      {images.length > 0 && (
        <label class="select-field">
          <span class="visually-hidden">{t.fabric.picture}</span>
          <select value={now ?? ''} onChange={(event) => choose(event.currentTarget.value)}>
            <option value="" disabled>
              {texture === 'mixed' ? t.fabric.different : t.fabric.noPicture}
            </option>
            {images.map((image) => (
              <option key={image.id} value={image.id}>
                {image.name}
              </option>
            ))}
          </select>
        </label>
      )}
      <button class="plain" disabled={state.editing.uploading.value} onClick={() => input.current?.click()}>
        {state.editing.uploading.value ? t.fabric.uploading : t.fabric.upload}
      </button>
      <input
        ref={input}
        type="file"
        hidden
        accept={kAccepted}
        aria-label={t.fabric.pictureFile}
        onChange={(event) => {
          const [file] = event.currentTarget.files ?? [];
          if (file) void textures.upload(ids, file.name, file);
          event.currentTarget.value = '';
        }}
      />
    </div>
  );
}

function Lie({ ids, texture }: { ids: string[]; texture: Texture }) {
  const { textures } = useCommands();
  const { scale_mm, offset, angle } = texture;
  const lay = (part: Partial<Texture>): void => void textures.lay(ids, part);
  return (
    <div class="field-row">
      <NumberField label={t.fabric.repeat} value={scale_mm} length take={(mm) => mm > 0 && lay({ scale_mm: mm })} />
      <NumberField label={t.fabric.angle} value={angle} unit="°" take={(degrees) => lay({ angle: degrees % 360 })} />
      <NumberField label={t.fabric.offsetX} value={offset[0]} length take={(x) => lay({ offset: [x, offset[1]] })} />
      <NumberField label={t.fabric.offsetY} value={offset[1]} length take={(y) => lay({ offset: [offset[0], y] })} />
    </div>
  );
}
