// How the page speaks to its reader: language and units. The browser keeps both.

import { useSignal } from '@preact/signals';
import { Icon } from '../controls/Icon';
import { Sheet } from '../controls/Sheet';
import type { Language } from '../texts/grammar';
import { chooseLanguage, language, languageNames, t } from '../texts/language';
import { TourButton } from './TourButton';
import { chooseUnit, lengthUnits, unit } from '../texts/units';

/** The button, and what it opens. */
export function Settings() {
  const open = useSignal(false);
  return (
    <>
      <button
        class="tool flat"
        title={t.frame.settings.title}
        aria-label={t.frame.settings.title}
        aria-haspopup="dialog"
        onClick={() => (open.value = true)}
      >
        <Icon name="sliders" />
      </button>
      {open.value && <Dialog close={() => (open.value = false)} />}
    </>
  );
}

function Dialog({ close }: { close: () => void }) {
  return (
    <Sheet class="settings" id="settings-title" title={t.frame.settings.title} beside={<TourButton class="phone-only" begun={close} />} close={close}>
      <div class="sheet-body">
        <Languages />
        <Units />
      </div>
    </Sheet>
  );
}

function Languages() {
  const lost = useSignal(false);
  const choose = (next: Language): void => {
    lost.value = false;
    chooseLanguage(next).catch(() => (lost.value = true));
  };
  return (
    <fieldset>
      <legend>{t.frame.settings.language}</legend>
      {(Object.keys(languageNames) as Language[]).map((one) => (
        <label key={one} class="check" lang={one}>
          <input type="radio" name="language" checked={language.value === one} onChange={() => choose(one)} />{' '}
          {languageNames[one]}
        </label>
      ))}
      {lost.value && (
        <p class="hint bad" role="alert">
          {t.frame.settings.lost}
        </p>
      )}
    </fieldset>
  );
}

function Units() {
  return (
    <fieldset>
      <legend>{t.frame.settings.units}</legend>
      {lengthUnits.map((one) => (
        <label key={one} class="check">
          <input type="radio" name="unit" checked={unit.value === one} onChange={() => chooseUnit(one)} />{' '}
          {t.frame.settings.unitNames[one]}
        </label>
      ))}
    </fieldset>
  );
}
