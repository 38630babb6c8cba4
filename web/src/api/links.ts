// Share links: those that an owner makes, and what one shows to whoever opens it.

import { decodeBody, type BodyMesh } from './body';
import { Http, kLongPatience } from './http';
import type { Answer, Fabric, Piece, Question, ShareLink, SharedJob } from './types';

export type LinkWish = Question<'shareJob'>;

export interface LinkApi {
  /** The links of a job, newest first. */
  links(job: string): Promise<ShareLink[]>;
  /** A new one; its secret is told this once. */
  share(job: string, wish: LinkWish): Promise<{ link: ShareLink; page: string }>;
  revoke(link: string): Promise<void>;
}

const part = encodeURIComponent;

export function makeLinkApi(http: Http): LinkApi {
  return {
    links: async (job) => (await http.get<Answer<'listLinksOfJob'>>(`/jobs/${part(job)}/links`)).links,
    share: (job, wish) => http.post(`/jobs/${part(job)}/links`, wish),
    revoke: async (link) => void (await http.send(`/links/${part(link)}`, { method: 'DELETE' })),
  };
}

/** What a link shows. After `open` a cookie shows the secret, on the addresses of this link alone. */
export interface SharedApi {
  open(secret: string): Promise<SharedJob>;
  show(id: string): Promise<SharedJob>;
  /** final.obj */
  cloth(id: string): Promise<string>;
  body(id: string): Promise<BodyMesh>;
  /** Colours and prints, without outlines. */
  pieces(id: string): Promise<{ pieces: Piece[]; fabrics: Fabric[] }>;
  pictureUrl(id: string, name: string): string;
  stillUrl(id: string, name: string, width: number): string;
  fileUrl(id: string, name: string): string;
  reportUrl(id: string): string;
  streamUrl(id: string): string;
}

const kNothing = { outline: [], holes: [], edges: [], notches: [], lines: [] };

export function makeSharedApi(http = new Http('/api/v1')): SharedApi {
  const at = (id: string, rest = ''): string => `/shared/${part(id)}${rest}`;
  return {
    open: (secret) => http.post('/shared', { secret } satisfies Question<'openLink'>),
    show: (id) => http.get(at(id)),
    cloth: (id) => http.text(at(id, '/cloth')),
    body: async (id) => decodeBody(await http.bytes(at(id, '/body'), kLongPatience)),
    pieces: async (id) => {
      const seen = await http.get<Answer<'sharedPieces'>>(at(id, '/pieces'));
      return { fabrics: seen.fabrics, pieces: seen.pieces.map((piece) => ({ ...kNothing, ...piece })) };
    },
    pictureUrl: (id, name) => http.url(at(id, `/pictures/${part(name)}`)),
    stillUrl: (id, name, width) => http.url(at(id, `/results/${part(name)}/small?width=${width}`)),
    fileUrl: (id, name) => http.url(at(id, `/results/${part(name)}`)),
    reportUrl: (id) => http.url(at(id, '/report')),
    streamUrl: (id) => http.socketUrl(at(id, '/stream')),
  };
}
