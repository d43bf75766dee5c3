// SPDX-License-Identifier: Apache-2.0
// The page for staff as people have it: in a browser, by keyboard, on a phone and at a desk; and as attackers do.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { after, before, test } from 'node:test';
import { ask, freePort, passphrase, secret, sizes, Stage, until } from './stage.mjs';

const axe = readFileSync(new URL('./node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
const pages = { exhibit: '/', faults: '/faults', log: '/log', doctor: '/doctor', visitors: '/report', backup: '/backup', curator: '/curator', hours: '/curator/hours',
                visit: '/curator/visit', texts: '/curator/texts', words: '/curator/words', themes: '/curator/themes', theme: '/curator/theme',
                collection: '/curator/collection' };

let stage;
before(async () => {
  mkdirSync('pictures', { recursive: true });
  stage = await Stage.open();
});
after(() => stage?.close());

const picture = (page, name) => page.screenshot({ path: `pictures/${name}.png`, fullPage: true });

// What axe finds that keeps somebody from using the page. No page lets a script of others in; what the test looks at it
// with goes past that.
async function findings(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const found = await window.axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] });
    return found.violations.filter((one) => one.impact === 'serious' || one.impact === 'critical')
      .map((one) => `${one.id}: ${one.nodes.map((node) => node.html).join(' | ')}`);
  });
}

// From the page's begin by Tab alone: what has the focus, one after the other, and whether that is seen.
async function walk(page) {
  await page.evaluate(() => { document.activeElement?.blur(); window.scrollTo(0, 0); });
  const seen = [];
  for (let i = 0; i < 250; ++i) {
    await page.keyboard.press('Tab');
    const now = await page.evaluate(() => {
      const here = document.activeElement;
      if (!here || here === document.body) return null;
      const style = getComputedStyle(here), box = here.getBoundingClientRect();
      here.dataset.walked = 'yes';
      return { name: here.textContent.trim() || here.name || here.id, isOutlined: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2,
               isInView: box.width > 0 && box.height > 0 && box.bottom > 0 && box.top < innerHeight && box.right > 0 && box.left < innerWidth };
    });
    if (now === null) break;
    seen.push(now);
  }
  const missed = await page.evaluate(() => [...document.querySelectorAll('a[href], button:not([tabindex]), select, textarea, input:not([type=hidden])')]
    .filter((one) => one.checkVisibility() && !one.dataset.walked && !(one.type === 'radio' && !one.checked)).map((one) => one.outerHTML));
  return { seen, missed };
}

async function tabTo(page, name) {
  for (let i = 0; i < 80; ++i) {
    await page.keyboard.press('Tab');
    if (await page.evaluate(() => document.activeElement.textContent.trim()) === name) return;
  }
  assert.fail(`Tab does not lead to ${name}`);
}

test('nobody sees anything without the passphrase, and a wrong one is said so', async () => {
  const page = await stage.newPage(sizes.phone);
  for (const path of Object.values(pages)) {
    await page.goto(stage.url + path);
    assert.equal(page.url(), `${stage.url}/login`, path);
  }
  await picture(page, 'login-phone');
  assert.deepEqual(await findings(page), []);
  await stage.type(page, 'not the passphrase');
  await page.getByRole('alert').filter({ hasText: 'That is not the passphrase.' }).waitFor();
  await page.locator('#passphrase:focus').waitFor();
  assert.deepEqual(await findings(page), []);
  await picture(page, 'login-wrong-phone');
  await page.close();
});

test('every page is usable at every size, by day and by night, and loads nothing from elsewhere', async () => {
  const page = await stage.newPage();
  const trouble = [];
  page.on('console', (message) => { if (message.type() === 'error' && !message.text().includes('503')) trouble.push(message.text()); });
  page.on('pageerror', (error) => trouble.push(String(error)));
  page.on('request', (one) => { if (!one.url().startsWith(stage.url) && !one.url().startsWith(`blob:${stage.url}`)) trouble.push(one.url()); });
  await stage.logIn(page);
  await until('the exhibit', async () => (await page.getByRole('heading', { level: 1 }).textContent()) !== 'The exhibit says nothing');
  await until('a picture', () => page.evaluate(() => document.getElementById('picture').src.startsWith('blob:')));
  await until('the held button', async () => (await page.locator('.buttons .closed').textContent()).startsWith('C'));
  for (const [size, viewport] of Object.entries(sizes))
    for (const scheme of ['light', 'dark']) {
      await page.setViewportSize(viewport);
      await page.emulateMedia({ colorScheme: scheme });
      for (const [name, path] of Object.entries(pages)) {
        const what = `${name}-${size}-${scheme}`;
        await page.goto(stage.url + path);
        if (name === 'exhibit') await until('a picture', () => page.evaluate(() => document.getElementById('picture').naturalWidth > 0));
        await picture(page, what);
        assert.deepEqual(await findings(page), [], what);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${what} is wider than the screen`);
      }
    }
  assert.deepEqual(trouble, []);
  await page.close();
});

test('all of a page is reached by keyboard, and what has the focus is seen', async () => {
  const page = await stage.newPage(sizes.phone);
  await stage.logIn(page);
  for (const [name, path] of Object.entries(pages)) {
    await page.goto(stage.url + path);
    const { seen, missed } = await walk(page);
    assert.deepEqual(missed, [], name);
    assert.deepEqual(seen.filter((one) => !one.isOutlined || !one.isInView), [], name);
    assert.equal(seen[0].name, name === 'visitors' ? "Back to the exhibit's page" : "To the page's content", name);
  }
  await page.close();
});

test('acts are done by keyboard, seen at once, and noted', async () => {
  const page = await stage.newPage();
  await stage.logIn(page);
  await until('the exhibit', async () => (await page.locator('.buttons li').count()) === 5);
  await tabTo(page, 'Test the lamps');
  await page.keyboard.press('Enter');
  await page.getByRole('status').filter({ hasText: 'The lamps light in turn.' }).waitFor();
  await page.getByText('The lamps are tested just now.').waitFor({ timeout: 11000 });
  await tabTo(page, 'Stand-by');
  await page.keyboard.press('Space');
  await page.getByText('on stand-by, as staff asked').waitFor();
  await page.goto(stage.url);
  await tabTo(page, 'Wake');
  await page.keyboard.press('Enter');
  await page.getByText('always open').waitFor();
  for (const what of ['logged in', 'asked for lamps', 'asked for standby', 'asked for wake'])
    assert.match(stage.notes(), new RegExp(`127.0.0.1 ${what}`));
  await page.close();
});

test('the picture and the words come by themselves, and stop where one says so', async () => {
  const page = await stage.newPage();
  await stage.logIn(page);
  const source = () => page.evaluate(() => document.getElementById('picture').src);
  const first = await until('a picture', async () => { const now = await source(); return now.startsWith('blob:') && now; });
  await until('the next', async () => (await source()) !== first);
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.waitForTimeout(1500);  // what was under way has come
  const held = await source();
  await page.waitForTimeout(3000);
  assert.equal(await source(), held);
  await page.close();
});

test('without its script the page does all of it', async () => {
  const context = await stage.newContext({ javaScriptEnabled: false });
  const page = await stage.newPage(sizes.phone, context);
  await stage.logIn(page);
  await page.getByText('Load the page again for a new picture.').waitFor();
  await until('the buttons', async () => {
    await page.getByRole('link', { name: 'Load again' }).click();
    return (await page.locator('.buttons .closed').count()) === 1;
  });
  await picture(page, 'exhibit-without-script');
  await page.getByRole('button', { name: 'Test the lamps' }).click();
  await page.getByRole('status').filter({ hasText: 'The lamps light in turn.' }).waitFor();
  assert.equal(await page.getByRole('button', { name: 'Pause' }).count(), 0);
  await page.getByRole('button', { name: 'Log out' }).click();
  await page.waitForURL(`${stage.url}/login`);
  await context.close();
});

test('a picture and a backup are saved, and a backup is looked into before it is restored', async () => {
  const page = await stage.newPage();
  await stage.logIn(page);
  const download = async (name) => {
    const [saved] = await Promise.all([page.waitForEvent('download'), page.getByRole('link', { name }).click()]);
    return saved.path();
  };
  const shot = readFileSync(await download('Save a picture at full size'));
  assert.equal(shot.readUInt32BE(16), 640);
  assert.equal(shot.readUInt32BE(20), 360);
  await page.goto(`${stage.url}/backup`);
  const backup = await download('Save a backup');
  await page.getByLabel(/^A backup of Quadrat/).setInputFiles({ name: 'no.tar.xz', mimeType: 'application/x-xz', buffer: Buffer.from('nonsense') });
  await page.getByRole('button', { name: 'Look into it' }).click();
  await page.getByRole('alert').waitFor();
  await page.goto(`${stage.url}/backup`);
  await page.getByLabel(/^A backup of Quadrat/).setInputFiles(backup);
  await page.getByRole('button', { name: 'Look into it' }).click();
  await page.getByRole('heading', { name: 'What this backup would change' }).waitFor();
  for (const [size, viewport] of Object.entries(sizes)) {
    await page.setViewportSize(viewport);
    await picture(page, `restore-${size}`);
    assert.deepEqual(await findings(page), []);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  }
  assert.deepEqual((await walk(page)).missed, []);
  await page.getByRole('button', { name: 'Change nothing' }).click();
  await page.getByRole('status').filter({ hasText: 'Nothing was changed.' }).waitFor();
  await page.close();
});

test('each language has its page, with its own direction', async () => {
  const page = await stage.newPage(sizes.phone);
  await stage.logIn(page);
  for (const name of ['العربية', 'Deutsch', 'English', 'Español', 'Français', 'isiXhosa']) {
    await page.getByRole('link', { name }).click();
    const [lang, dir] = await page.evaluate(() => [document.documentElement.lang, document.documentElement.dir]);
    assert.equal(dir, lang === 'ar' ? 'rtl' : 'ltr');
    for (const path of ['/', '/faults', '/log', '/doctor', '/backup', '/curator', '/curator/hours', '/curator/texts', '/curator/words', '/curator/theme']) {
      await page.goto(stage.url + path);
      assert.equal(await page.evaluate(() => document.documentElement.lang), lang, 'it is kept');
      assert.deepEqual(await findings(page), [], `${lang} ${path}`);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${lang} ${path} is wider than the screen`);
    }
    await page.goto(stage.url);
    await picture(page, `exhibit-${lang}`);
  }
  await page.getByRole('link', { name: 'English' }).click();
  await page.close();
});

test('a curator changes by keyboard what is said, sees it drawn, and takes it back', async () => {
  const page = await stage.newPage();
  await stage.logIn(page);
  await page.goto(`${stage.url}/curator/texts?in=fr`);
  await page.getByLabel('attract', { exact: true }).fill('Venez voir <b>ceci</b>');
  await page.getByRole('button', { name: 'Show it: attract' }).focus();
  await page.keyboard.press('Enter');
  // Whoever holds a button for long plays with one, and is waited for the longer.
  await until('the preview', () => page.evaluate(() => document.querySelector('#preview img').naturalWidth > 0), 180000);
  await picture(page, 'curator-preview');
  await page.locator('#preview img').screenshot({ path: 'pictures/preview.png' });
  assert.deepEqual(await findings(page), []);
  assert.equal(await page.getByLabel('attract', { exact: true }).inputValue(), 'Venez voir <b>ceci</b>');
  await page.getByLabel('attract', { exact: true }).focus();
  await page.keyboard.press('Enter');
  await page.getByRole('status').filter({ hasText: 'Saved.' }).waitFor();
  assert.ok(page.url().includes('in=fr'), 'the same language');
  await page.goto(`${stage.url}/curator/visit`);
  await page.getByLabel('Rounds').fill('7');
  await page.getByRole('button', { name: 'Save' }).last().click();
  await page.getByRole('status').filter({ hasText: 'Saved.' }).waitFor();
  await page.goto(`${stage.url}/curator`);
  assert.deepEqual(await page.locator('.changes b').allTextContents(), ['Visits and languages', 'Texts']);
  await picture(page, 'curator-changes');
  await tabTo(page, 'Take back the last change');
  await page.keyboard.press('Enter');
  await page.getByRole('status').filter({ hasText: 'Taken back: Visits and languages.' }).waitFor();
  await page.goto(`${stage.url}/curator/visit`);
  assert.equal(await page.getByLabel('Rounds').inputValue(), '6');
  await page.close();
});

test('a preview waits while somebody plays and says so, in every language', async () => {
  const visit = ['at 3s press A', ...Array.from({ length: 20 }, () => 'after 4s press A')].join('\n');
  const played = await Stage.open(`${visit}\nwait 3000s\n`, '[visit]\npatience_s = 5\ncountdown_s = 2\nfinale_s = 5\ndescribe_words = 0\n');
  try {
    const page = await played.newPage();
    await played.logIn(page);
    await until('a visitor', () => played.processes[0].said.includes('a visit begins'));
    const said = new Set();
    for (const [code, waits] of [['ar', 'هناك من يلعب'], ['de', 'Gerade spielt jemand'], ['es', 'Alguien está jugando'],
                                 ['fr', 'Quelqu’un joue'], ['xh', 'Kukho umntu odlalayo'], ['en', 'Somebody is playing']]) {
      await page.locator(`a[hreflang="${code}"]`).click();
      await page.goto(`${played.url}/curator/texts?in=fr`);
      await page.locator('button[value="text.attract"]').click();
      await page.locator('#preview').getByRole('status').filter({ hasText: waits }).waitFor();
      said.add(await page.locator('#preview-state').textContent());
      assert.equal(await page.evaluate(() => document.querySelector('#preview img').naturalWidth), 0, 'nothing is drawn meanwhile');
      assert.equal(await page.locator('#preview img').isVisible(), false, 'and no broken picture is seen');
      await picture(page, `curator-waits-${code}`);
      assert.deepEqual(await findings(page), [], code);
    }
    assert.equal(said.size, 6);
    await until('the preview', () => page.evaluate(() => document.querySelector('#preview img').naturalWidth > 0), 120000);
    assert.equal(await page.locator('#preview-state').textContent(), 'As visitors would see it. Nothing is saved yet.');
    assert.ok(await page.locator('#preview img').isVisible());
    await page.close();
  } finally {
    await played.close();
  }
});

test('what cannot be is said once, and what was written stays', async () => {
  const page = await stage.newPage(sizes.phone);
  await stage.logIn(page);
  await page.goto(`${stage.url}/curator/hours`);
  await page.getByLabel('Monday').fill('nine to five');
  await page.getByLabel('Monday').press('Enter');
  await page.getByRole('alert').filter({ hasText: 'is no opening time' }).waitFor();
  assert.equal(await page.getByRole('alert').filter({ hasText: /./ }).count(), 1);
  assert.equal(await page.getByLabel('Monday').inputValue(), 'nine to five');
  await picture(page, 'curator-refused');
  assert.deepEqual(await findings(page), []);
  await page.close();
});

test('a log shows no secret and runs no script', async () => {
  const page = await stage.newPage();
  await stage.logIn(page);
  await page.goto(`${stage.url}/log`);
  const text = await page.locator('main').textContent();
  assert.match(text, /<script>document\.title/);
  assert.notEqual(await page.title(), 'attacked');
  assert.ok(!text.includes(secret) && !text.includes('open-sesame'));
  assert.ok(!text.includes('line 102\n') && text.includes('line 103\n'), 'the last 200 lines');
  await page.goto(`${stage.url}/faults`);
  assert.match(await page.locator('main').textContent(), /button B is <b>stuck<\/b>/);
  await page.close();
});

test('a session that is over leads back to the login, from an open page too', async () => {
  const open = await stage.newPage();
  await stage.logIn(open);
  const other = await stage.newPage();
  await other.goto(stage.url);
  await other.getByRole('button', { name: 'Log out' }).click();
  await open.waitForURL(`${stage.url}/login`);
  await stage.context.addCookies([{ name: 'quadrat-desk', value: '0'.repeat(64), url: stage.url }]);
  await open.goto(`${stage.url}/log`);
  assert.equal(open.url(), `${stage.url}/login`);
  await Promise.all([open.close(), other.close()]);
});

test('a page of another site does nothing here and shows nothing of it', async () => {
  const page = await stage.newPage();
  await stage.logIn(page);
  const token = await page.locator('input[name=token]').first().inputValue();
  const evilPort = await freePort();
  const form = (path, fields) => `<form method="post" action="${stage.url}${path}">` +
    Object.entries(fields).map(([name, value]) => `<input name="${name}" value="${value}">`).join('') + '<button>go</button></form>';
  const evil = createServer((asked, answer) => answer.setHeader('Content-Type', 'text/html')
    .end(form('/act', { act: 'standby', token }) + `<iframe src="${stage.url}/"></iframe>`));
  await new Promise((done) => evil.listen(evilPort, '127.0.0.1', done));
  try {
    // Another port is the same site: its cookies go along, so that the origin has to tell.
    for (const host of ['127.0.0.1', 'localhost']) {
      await page.goto(`http://${host}:${evilPort}/`);
      assert.equal(await page.evaluate(async (url) => { try { return (await fetch(url, { credentials: 'include' })).status; } catch { return 'refused'; } }, `${stage.url}/health.json`), 'refused');
      assert.ok(!(await page.frames()[1].content()).includes('verdict'), 'no page is shown within another');
      await Promise.all([page.waitForURL(`${stage.url}/act`), page.getByRole('button').click()]);
      await page.getByText('This form was sent by a page of another site.').waitFor();
    }
  } finally {
    await new Promise((done) => { evil.close(done); evil.closeAllConnections(); });
  }
  assert.ok(!stage.notes().trimEnd().endsWith('standby'));
  await page.close();
});

test('no path leads anywhere else', async () => {
  const page = await stage.newPage();
  await stage.logIn(page);
  const [{ value }] = (await stage.context.cookies(stage.url)).filter((one) => one.name === 'quadrat-desk');
  for (const path of ['/../../etc/passwd', '/%2e%2e/%2e%2e/etc/passwd', '/..%2f..%2fetc/passwd', '//etc/passwd', '/faults/../../desk.passphrase',
                      '/faults/..%2f..%2fdesk.passphrase', '/faults/%2e%2e/desk.passphrase', '/faults//etc/passwd', '/faults/fault-1.png%00.txt',
                      '/desk.css/../desk.passphrase', '/state/desk.passphrase', '/./', '/login/../doctor', '/\\..\\..\\etc\\passwd']) {
    const answer = await ask(stage.port, 'GET', path, { Cookie: `quadrat-desk=${value}` });
    assert.ok([400, 404].includes(answer.status), `${path}: ${answer.status}`);
    assert.ok(!/root:|scrypt\$/.test(answer.body), path);
  }
  await page.close();
});

test('whoever guesses has to wait', async () => {
  const page = await stage.newPage(sizes.phone);
  const guess = () => ask(stage.port, 'POST', '/login', { 'Content-Type': 'application/x-www-form-urlencoded' }, 'passphrase=guess');
  let status = 0;
  for (let i = 0; i < 6 && status !== 429; ++i) ({ status } = await guess());
  assert.equal(status, 429);
  await page.goto(`${stage.url}/login`);
  await stage.type(page, passphrase);
  await page.getByText('Too many wrong passphrases').waitFor();
  assert.deepEqual(await findings(page), []);
  await page.close();
});
