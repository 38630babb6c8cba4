// The real server as a child of a test: started on a free port, killed and started again on the same port and data.

import { execFileSync, spawn } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url));
const program = process.env.TOILE_PROGRAM ?? join(root, 'build/release/toile');
const web = process.env.TOILE_WEB ?? join(root, 'web/dist');

/** Of an account that a test has made. */
export const passwordOf = (name) => `${name}, ${name} and a needle`;

export class Service {
  data = mkdtempSync(join(tmpdir(), 'toile-e2e-'));
  port = 0;
  /** Whose requests those of the test are, where there are accounts. */
  token = '';
  #child = null;
  #sample;

  /** `sample` is the folder of the project that a new store begins with; empty: with none. */
  constructor(sample = join(root, 'samples/skirt')) {
    this.#sample = sample;
  }

  get url() {
    return `http://127.0.0.1:${this.port}`;
  }

  /** Runs the program's own verbs over the store, and gives what they print. */
  run(words, input = '') {
    return execFileSync(program, [...words, '--data', this.data], { input, encoding: 'utf8' });
  }

  /** Makes an account with a password and gives a token of it; before the start, or it comes too late. */
  addAccount(name, { flags = [], scopes = 'read,submit' } = {}) {
    this.run(['account', 'add', name, ...flags]);
    this.run(['account', 'password', name], `${passwordOf(name)}\n`);
    return this.run(['token', 'make', name, '--scopes', scopes]).trim();
  }

  /** Resolves once it says that it answers. */
  async start() {
    if (!existsSync(program)) throw new Error(`${program} is not there: ./run build makes it`);
    const options = [
      '--port',
      String(this.port),
      '--data',
      this.data,
      '--workers',
      '2',
      '--web',
      web,
      ...(this.#sample ? ['--sample', this.#sample] : ['--no-sample']),
    ];
    const child = spawn(program, ['serve', ...options], { stdio: ['ignore', 'pipe', 'pipe'] });
    this.#child = child;
    let said = '';
    const address = new Promise((done, fail) => {
      const listen = (chunk) => {
        said += chunk;
        const port = /http:\/\/127\.0\.0\.1:(\d+)/.exec(said)?.[1];
        if (port) done(Number(port));
      };
      child.stdout.on('data', listen);
      child.stderr.on('data', listen);
      child.on('exit', (code, signal) =>
        fail(new Error(`the server ended (${code ?? signal}) before it answered:\n${said}`)),
      );
    });
    this.port = await address;
  }

  /** Ends it as a crash would. */
  async kill() {
    await this.#end('SIGKILL');
  }

  async stop() {
    await this.#end('SIGTERM');
    rmSync(this.data, { recursive: true, force: true });
  }

  async #end(signal) {
    const child = this.#child;
    this.#child = null;
    if (!child || child.exitCode !== null || child.signalCode !== null) return;
    const gone = new Promise((done) => child.on('exit', done));
    child.kill(signal);
    await gone;
  }

  async get(path, init = {}) {
    const headers = { ...init.headers, ...(this.token && { Authorization: `Bearer ${this.token}` }) };
    const response = await fetch(`${this.url}/api/v1${path}`, { ...init, headers });
    if (!response.ok) throw new Error(`${path}: ${response.status} ${await response.text()}`);
    return response;
  }

  async post(path, body = {}) {
    const text = await this.get(path, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify(body),
    });
    return text.json();
  }

  /** Keeps a file and gives its id. */
  async upload(kind, name, bytes) {
    const headers = { 'Content-Type': 'application/octet-stream' };
    const response = await this.get(`/assets?kind=${kind}&name=${name}`, { method: 'POST', headers, body: bytes });
    return (await response.json()).id;
  }
}
