// One way to ask the service something, and one kind of error that comes back.

/** What went wrong, in the service's words (RFC 9457) or, when it did not answer, in ours. */
export class ApiError extends Error {
  constructor(
    /** HTTP status, 0 when there was no answer. */
    readonly status: number,
    /** Stable code such as "dxf.truncated"; "net.unreachable" when there was no answer. */
    readonly code: string,
    /** A sentence for a person. */
    readonly detail: string,
    /** File and line, piece, edge or JSON pointer at fault; may be empty. */
    readonly where: string = '',
  ) {
    super(detail);
    this.name = 'ApiError';
  }

  /** Whether the service could not be reached at all, so that asking again later may help. */
  get unreachable(): boolean {
    return this.status === 0 || this.status === 502 || this.status === 503 || this.status === 504;
  }
}

export type Fetch = (input: string, init?: RequestInit) => Promise<Response>;

/** Longest wait for an answer, ms. Submitting reads the whole pattern, so it is generous. */
const kPatience = 20_000;
/** Where the service has to search: seams of a garment of many pieces, on a busy machine. */
export const kLongPatience = 180_000;

const text = (value: unknown): string => (typeof value === 'string' ? value : '');

/** Reads a problem document; a body that is none still gives an error with the status. */
export async function problemOf(response: Response): Promise<ApiError> {
  let body: Record<string, unknown> = {};
  try {
    body = (await response.json()) as Record<string, unknown>;
  } catch {
    // A proxy's page or an empty body: the status has to do.
  }
  const code = text(body.code) || `http.${response.status}`;
  const detail = text(body.detail) || text(body.title) || `The server answered ${response.status}.`;
  return new ApiError(response.status, code, detail, text(body.where));
}

const unreachable = (): ApiError => new ApiError(0, 'net.unreachable', 'The server does not answer.');

/** An answer can break off, or take too long, after its header has come. @throws ApiError */
async function whole<T>(reading: Promise<T>): Promise<T> {
  try {
    return await reading;
  } catch {
    throw unreachable();
  }
}

export class Http {
  constructor(
    readonly base: string,
    private readonly fetch_: Fetch = (input, init) => fetch(input, init),
  ) {}

  url(path: string): string {
    return this.base + path;
  }

  /** The WebSocket address of a path, on the page's own host. */
  socketUrl(path: string): string {
    const url = new URL(this.url(path), globalThis.location?.href ?? 'http://localhost/');
    url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
    return url.href;
  }

  /** @throws ApiError for everything but a 2xx answer. */
  async send(path: string, init: RequestInit = {}): Promise<Response> {
    let response: Response;
    try {
      response = await this.fetch_(this.url(path), { signal: AbortSignal.timeout(kPatience), ...init });
    } catch {
      throw unreachable();
    }
    if (!response.ok) throw await problemOf(response);
    return response;
  }

  async get<T>(path: string, patience = kPatience): Promise<T> {
    return this.json(path, { signal: AbortSignal.timeout(patience) });
  }

  async post<T>(path: string, body?: unknown, headers: Record<string, string> = {}, patience = kPatience): Promise<T> {
    return this.json(path, {
      signal: AbortSignal.timeout(patience),
      method: 'POST',
      headers: body === undefined ? headers : { 'Content-Type': 'application/json', ...headers },
      body: body === undefined ? undefined : JSON.stringify(body),
    });
  }

  async json<T>(path: string, init: RequestInit): Promise<T> {
    return whole((await this.send(path, init)).json() as Promise<T>);
  }

  async text(path: string): Promise<string> {
    return whole((await this.send(path)).text());
  }

  async bytes(path: string, patience = kPatience): Promise<ArrayBuffer> {
    return whole((await this.send(path, { signal: AbortSignal.timeout(patience) })).arrayBuffer());
  }
}

/** Names the revision that a change is made for. */
export const matching = (revision: number): Record<string, string> => ({ 'If-Match': `"${revision}"` });
