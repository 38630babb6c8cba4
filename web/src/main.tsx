// Where the page begins: as the whole of it, or as what a share link shows, which asks for nothing else.

import { effect } from '@preact/signals';
import { parseRoute } from './state/routes';
import { firstLanguage, speak, speakCodes } from './texts/language';
import './styles/main.css';

const isShared = (): boolean => parseRoute(location.hash).name === 'shared';
const route = parseRoute(location.hash);
window.addEventListener('hashchange', () => isShared() !== (route.name === 'shared') && location.reload());

// Without its texts the page speaks English, and is there all the same.
await speak(firstLanguage(navigator.languages)).catch(() => undefined);

if (route.name === 'shared') {
  const { startShared } = await import('./sharedPage');
  startShared(route.secret, document.getElementById('page')!);
} else {
  await import('./page');
}

// Until they are there, messages stand in the service's own words.
effect(() => void speakCodes().catch(() => undefined));
