// Where the page begins: as the whole of it, or as what a share link shows, which asks for nothing else.

import { parseRoute } from './state/routes';
import './styles/main.css';

const isShared = (): boolean => parseRoute(location.hash).name === 'shared';
const route = parseRoute(location.hash);
window.addEventListener('hashchange', () => isShared() !== (route.name === 'shared') && location.reload());

if (route.name === 'shared') {
  const { startShared } = await import('./sharedPage');
  startShared(route.secret, document.getElementById('page')!);
} else {
  await import('./page');
}
