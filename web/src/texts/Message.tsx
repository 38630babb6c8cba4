// A message of the service: in the reader's language by its code, with the service's own English words small beside it.

import { sentence, told, toldByForm } from './told';

export function Told({ code, detail }: { code: string; detail: string }) {
  const { text, detail: own } = told(code, detail);
  return (
    <>
      {sentence(text)}
      {own !== '' && (
        <small class="told" lang="en">
          {sentence(own)}
        </small>
      )}
    </>
  );
}

/** A sentence of the service that has no code: in the reader's language by its form, or as it is. */
export function Said({ text }: { text: string }) {
  const words = toldByForm(text);
  return words === null ? <span lang="en">{sentence(text)}</span> : <>{sentence(words)}</>;
}
