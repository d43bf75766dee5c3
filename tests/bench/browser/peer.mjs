// SPDX-License-Identifier: Apache-2.0
// node peer.mjs FOLDER: shows FOLDER/{0,1,2,3}.glb from the cameras of FOLDER/views.json in Chromium and prints one line
// of JSON: first_frame_ms since Chromium was started, built_ms since the page was, the median frame_ms, memory_mb (the
// most that all its processes held, shared pages once), triangles of a frame, renderer. FOLDER/page.png is what it drew.
// Ends with 1 and one line on stderr where it cannot.
import { spawn } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { dirname, extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = process.argv[2];
const here = dirname(fileURLToPath(import.meta.url));
const patience_ms = 300000;
const kinds = { '.html': 'text/html', '.mjs': 'text/javascript', '.js': 'text/javascript', '.json': 'application/json' };

// What the page asks for, by the beginning of its address.
function file_of(url) {
  const path = normalize(decodeURIComponent(url.split('?')[0]));
  if (path.startsWith('/three/')) return join(here, 'node_modules', path);
  if (path.startsWith('/scenes/')) return join(folder, path.slice('/scenes/'.length));
  if (path === '/views.json') return join(folder, path);
  return join(here, path === '/' ? 'index.html' : path);
}

function serve(on_told) {
  return createServer((request, answer) => {
    if (request.method === 'POST') {
      const parts = [];
      request.on('data', (part) => parts.push(part));
      request.on('end', () => { answer.end(); on_told(request.url.slice('/told/'.length), JSON.parse(Buffer.concat(parts))); });
      return;
    }
    try {
      const path = file_of(request.url);
      const bytes = readFileSync(path);
      answer.writeHead(200, { 'content-type': kinds[extname(path)] ?? 'application/octet-stream' }).end(bytes);
    } catch { answer.writeHead(404).end(); }
  });
}

// All that descend from a process, itself too.
function family_of(root) {
  const parents = new Map();
  for (const name of readdirSync('/proc')) {
    if (!/^\d+$/.test(name)) continue;
    try {
      const stat = readFileSync(`/proc/${name}/stat`, 'latin1');
      parents.set(Number(name), Number(stat.slice(stat.lastIndexOf(')') + 2).split(' ')[1]));
    } catch { /* it has ended */ }
  }
  const family = new Set([root]);
  for (let grown = 0; grown !== family.size;) {
    grown = family.size;
    for (const [child, parent] of parents) if (family.has(parent)) family.add(child);
  }
  return [...family];
}

// A page that several share counts in parts.
function memory_mb(root) {
  let kb = 0;
  for (const id of family_of(root)) {
    try { kb += Number(/^Pss:\s+(\d+)/m.exec(readFileSync(`/proc/${id}/smaps_rollup`, 'latin1'))?.[1] ?? 0); }
    catch { /* it has ended */ }
  }
  return kb / 1024;
}

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

function start_chromium(port, profile, size) {
  return spawn('chromium', [
    '--headless', '--no-sandbox', '--no-first-run', '--disable-extensions', '--disable-background-networking',
    '--use-gl=angle', '--use-angle=gles-egl', '--ignore-gpu-blocklist', '--disable-gpu-watchdog',
    '--disable-frame-rate-limit', `--user-data-dir=${profile}`, `--window-size=${size.width},${size.height}`,
    `http://127.0.0.1:${port}/`], { stdio: ['ignore', 'ignore', 'pipe'], detached: true });
}

async function measure() {
  const { size } = JSON.parse(readFileSync(join(folder, 'views.json')));
  const profile = mkdtempSync(join(tmpdir(), 'quadrat-peer-'));
  const result = {};
  let chromium, server, watch, said = '';
  try {
    await new Promise((done, fail) => {
      let begun_ms = 0;
      server = serve((what, told) => {
        if (what === 'failed') return fail(new Error(`the page failed: ${told.why}`));
        if (what === 'first') Object.assign(result, told, { first_frame_ms: performance.now() - begun_ms });
        if (what !== 'frames') return;
        writeFileSync(join(folder, 'page.png'), Buffer.from(told.picture.split(',')[1], 'base64'));
        Object.assign(result, { frame_ms: median(told.frame_ms), triangles: told.triangles });
        done();
      });
      server.listen(0, '127.0.0.1', () => {
        begun_ms = performance.now();
        chromium = start_chromium(server.address().port, profile, size);
        chromium.stderr.on('data', (text) => { said = (said + text).slice(-2000); });
        chromium.on('error', fail);
        chromium.on('exit', () => fail(new Error(`Chromium ended before it had drawn: ${said.trim().split('\n').pop()}`)));
        result.memory_mb = 0;
        watch = setInterval(() => { result.memory_mb = Math.max(result.memory_mb, memory_mb(chromium.pid)); }, 250);
      });
      setTimeout(() => fail(new Error(`Chromium has not drawn for ${patience_ms / 1000} s`)), patience_ms).unref();
    });
  } finally {
    clearInterval(watch);
    chromium?.removeAllListeners('exit');
    try { process.kill(-chromium.pid, 'SIGKILL'); } catch { /* it has ended */ }
    server.closeAllConnections();
    server.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
  return result;
}

measure().then((result) => { console.log(JSON.stringify(result)); process.exit(0); },
               (error) => { console.error(`browser: ${error.message}`); process.exit(1); });
