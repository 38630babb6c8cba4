// A message of the service: in the reader's language by its code, with the service's own English words small beside it.

import { sentence, told } from './told';

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
