// SPDX-License-Identifier: Apache-2.0
// An exhibit, its desk and a browser, on this machine alone; all of it ends with the test.
import { spawn } from 'node:child_process';
import { mkdtempSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer, request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { deflateSync } from 'node:zlib';
import { chromium } from 'playwright-core';

export const passphrase = 'a sentence of staff';
export const secret = 'hunter22-of-the-broker';
export const sizes = { phone: { width: 390, height: 844 }, desktop: { width: 1280, height: 800 } };

const program = process.env.QUADRAT_BINARY;

export async function freePort() {
  const server = createServer();
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  const { port } = server.address();
  await new Promise((done) => server.close(done));
  return port;
}

// Until it is as wished; what it was last, where it never is.
export async function until(what, holds, patience_ms = 60000) {
  const begun = Date.now();
  for (let last; ; await new Promise((done) => setTimeout(done, 50))) {
    try { last = await holds(); } catch (trouble) { last = trouble; }
    if (last && !(last instanceof Error)) return last;
    if (Date.now() - begun > patience_ms) throw new Error(`${what} has not come: ${last}`);
  }
}

// A request as its bytes are written here: fetch() would tidy its path.
export function ask(port, method, path, headers = {}, body = '') {
  return new Promise((done, fail) => {
    const asked = request({ host: '127.0.0.1', port, method, path, headers, agent: false }, (answer) => {
      const parts = [];
      answer.on('data', (part) => parts.push(part));
      answer.on('end', () => done({ status: answer.statusCode, headers: answer.headers,
                                    body: Buffer.concat(parts).toString('latin1') }));
    });
    asked.on('error', fail);
    asked.end(body);
  });
}

// A picture of one colour, for a fault that was.
function plainPng(width, height) {
  const crcOf = (bytes) => {
    let crc = ~0;
    for (const byte of bytes) {
      crc ^= byte;
      for (let i = 0; i < 8; ++i) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
    }
    return ~crc >>> 0;
  };
  const chunk = (type, bytes) => {
    const named = Buffer.concat([Buffer.from(type), bytes]);
    const head = Buffer.alloc(4), tail = Buffer.alloc(4);
    head.writeUInt32BE(bytes.length);
    tail.writeUInt32BE(crcOf(named));
    return Buffer.concat([head, named, tail]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 2], 8);
  const row = Buffer.concat([Buffer.from([0]), Buffer.alloc(3 * width, 0x58)]);
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', header),
                        chunk('IDAT', deflateSync(Buffer.concat(Array(height).fill(row)))), chunk('IEND', Buffer.alloc(0))]);
}

export class Stage {
  // `visit`: what its visitor presses; `settings`: what its site says besides.
  static async open(visit = 'at 2s press B\nafter 1s hold C for 3000s\n', settings = '') {
    const stage = new Stage();
    stage.folder = mkdtempSync(join(tmpdir(), 'quadrat-browser-'));
    stage.state = join(stage.folder, 'state');
    mkdirSync(join(stage.state, 'faults'), { recursive: true });
    stage.port = await freePort();
    stage.url = `http://127.0.0.1:${stage.port}`;
    stage.processes = [];
    stage.write(visit, settings);
    await stage.setPassphrase();
    stage.start('run', '--display', 'headless', '--size', '640x360', '--input', `script:${join(stage.folder, 'visit.script')}`,
                '--seed', '5', '--speed', '1.001');
    stage.start('desk', '--log', join(stage.folder, 'exhibit.log'));
    await until('the desk', async () => {
      for (const child of stage.processes) if (child.exitCode !== null) return { ended: child.said };
      return (await ask(stage.port, 'GET', '/login')).status === 200;
    }).then((how) => { if (how.ended) throw new Error(how.ended); });
    // Playwright gives each browser a profile of its own.
    stage.browser = await chromium.launch({
      executablePath: '/usr/bin/chromium', headless: true,
      args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
             '--disable-component-update', '--disable-sync'] });
    stage.context = await stage.newContext();
    return stage;
  }

  write(visit, settings) {
    const inFolder = (name, text) => writeFileSync(join(this.folder, name), text);
    inFolder('quadrat.toml', `[picture]\nland_samples = 65\n[desk]\nlisten = "127.0.0.1:${this.port}"\n` +
             `[fleet]\nname = "Foyer, 2nd floor"\nbroker = "mqtt://127.0.0.1:1883"\nuser = "exhibit"\n` +
             `password_file = "${join(this.folder, 'password')}"\n${settings}`);
    inFolder('password', `${secret}\n`);
    inFolder('visit.script', visit);
    inFolder('exhibit.log', Array.from({ length: 300 }, (_, i) => `2026-11-26 11:${String(i % 60).padStart(2, '0')}:00 line ${i}\n`).join('') +
             `<script>document.title = 'attacked'</script>\nthe broker refuses ${secret}\npassword=open-sesame\n`);
    const at = 1795680000;
    const faults = [{ text: 'button B is <b>stuck</b>, since 61 s', first_s: at, last_s: at + 7200, count: 17,
                      picture: join(this.state, 'faults', 'fault-1.png') },
                    { text: 'the disk has not answered for 5 s', first_s: at + 9000, last_s: at + 9000, count: 1, picture: '' }];
    writeFileSync(join(this.state, 'faults', 'faults.json'), JSON.stringify({ quadrat: 'faults', version: 1, faults }));
    writeFileSync(join(this.state, 'faults', 'fault-1.png'), plainPng(640, 360));
  }

  setPassphrase() {
    const child = spawn(program, ['desk', '--set-passphrase', '--state', this.state], { stdio: ['pipe', 'ignore', 'inherit'] });
    child.stdin.end(`${passphrase}\n`);
    return new Promise((done, fail) => child.on('exit', (status) => (status === 0 ? done() : fail(new Error(`${status}`)))));
  }

  start(command, ...more) {
    const child = spawn(program, [command, '--config', join(this.folder, 'quadrat.toml'), '--state', this.state, ...more],
                        { stdio: ['ignore', 'ignore', 'pipe'], cwd: this.folder, env: { ...process.env, RUNTIME_DIRECTORY: '' } });
    child.said = '';
    child.stderr.on('data', (part) => { child.said = (child.said + part).slice(-4000); });
    this.processes.push(child);
    return child;
  }

  notes() { return readFileSync(join(this.state, 'desk.log'), 'utf8'); }

  newContext(more = {}) { return this.browser.newContext({ locale: 'en-GB', acceptDownloads: true, ...more }); }

  async newPage(size = sizes.desktop, context = this.context) {
    const page = await context.newPage();
    await page.setViewportSize(size);
    page.setDefaultTimeout(15000);
    return page;
  }

  // By keyboard alone: the field has the focus once the page was drawn.
  async type(page, words) {
    await page.locator('#passphrase:focus').waitFor();
    await page.keyboard.type(words);
    await page.keyboard.press('Enter');
  }

  async logIn(page) {
    await page.goto(`${this.url}/login`);
    await this.type(page, passphrase);
    await page.waitForURL(`${this.url}/`);
  }

  async close() {
    if (this.browser) await this.browser.close();
    for (const child of this.processes) {
      if (child.exitCode !== null) continue;
      const ended = new Promise((done) => child.on('exit', done));
      child.kill('SIGTERM');
      await ended;
    }
    rmSync(this.folder, { recursive: true, force: true });
  }
}
