// Keeps one job's stream and decodes its frames away from the page's thread.

import type { FromWorker, ToWorker } from '../api/messages';
import { StreamReceiver } from '../api/StreamReceiver';
import type { Clock, Socket } from '../api/JobStream';

interface Scope {
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
  postMessage(message: FromWorker, transfer?: Transferable[]): void;
}

const scope = self as unknown as Scope;
const clock: Clock = {
  after: (ms, what) => setTimeout(what, ms) as unknown as number, // beside the types of Node
  cancel: (id) => clearTimeout(id),
  random: () => Math.random(),
};

let receiver: StreamReceiver | null = null;

function watch(number: number, url: string): void {
  receiver?.close();
  receiver = new StreamReceiver(url, (address) => new WebSocket(address) as unknown as Socket, clock, {
    connection: (connection) => scope.postMessage({ type: 'connection', watch: number, connection }),
    text: (message) => scope.postMessage({ type: 'text', watch: number, message }),
    topology: (topology) => scope.postMessage({ type: 'topology', watch: number, topology }),
    frame: (positions, moment) =>
      scope.postMessage({ type: 'frame', watch: number, positions, moment }, [positions.buffer]),
  });
  receiver.open();
}

scope.onmessage = ({ data }) => {
  switch (data.type) {
    case 'watch':
      return watch(data.watch, data.url);
    case 'leave':
      receiver?.close();
      receiver = null;
      return;
    case 'poke':
      return receiver?.poke();
    case 'say':
      return receiver?.say(data.word);
    case 'buffer':
      return receiver?.giveBack(data.positions);
  }
};
