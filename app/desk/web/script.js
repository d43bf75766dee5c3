'use strict';
// Keeps a page as the exhibit is, once a second: what is marked data-live is taken from the page as it would be now.
// Without this script, the page is loaded again by hand.
const at = (id) => document.getElementById(id);
const isWatching = () => !document.hidden && at('pause').getAttribute('aria-pressed') !== 'true';

async function ask(path) {
  const answer = await fetch(path, { redirect: 'manual', signal: AbortSignal.timeout(10000) });
  // The session is over.
  if (answer.status === 401 || answer.type === 'opaqueredirect') location.assign('/login');
  return answer;
}

function isLost(lost) {
  const place = at('lost');
  if (place.hidden !== lost) return;
  place.textContent = lost ? place.dataset.text : '';
  place.hidden = !lost;
}

async function words() {
  const answer = await ask(location.pathname);
  if (!answer.ok) throw new Error(answer.statusText);
  const now = new DOMParser().parseFromString(await answer.text(), 'text/html');
  for (const old of document.querySelectorAll('[data-live]')) {
    const fresh = now.getElementById(old.id);
    if (!fresh || fresh.outerHTML === old.outerHTML) continue;
    old.className = fresh.className;
    old.replaceChildren(...fresh.childNodes);
  }
}

let shown = '';
async function picture() {
  const answer = await ask('/picture.png');
  const caption = at('pictured');
  if (!answer.ok) { caption.textContent = caption.dataset.dark; return; }
  const fresh = URL.createObjectURL(await answer.blob());
  at('picture').src = fresh;
  if (shown) URL.revokeObjectURL(shown);
  shown = fresh;
  caption.textContent = caption.dataset.shown;
}

// One after the other: whoever answers slowly is not asked more often.
async function look() {
  if (isWatching()) {
    try { await words(); await picture(); isLost(false); } catch (trouble) { isLost(true); }
  }
  setTimeout(look, 1000);
}

if (at('pause')) {
  at('pause').hidden = false;
  at('reload').hidden = true;
  at('pause').addEventListener('click', () => {
    at('pause').setAttribute('aria-pressed', String(isWatching()));
  });
  look();
}

// A preview is drawn when nobody plays: it is asked for until it is there, and why it is not yet is said.
async function preview() {
  const state = at('preview-state');
  const say = (words) => { if (state.textContent !== words) state.textContent = words; };
  try {
    const answer = await ask('/preview.png');
    if (answer.ok) {
      at('previewed').src = URL.createObjectURL(await answer.blob());
      at('previewed').hidden = false;
      say(state.dataset.drawn);
      return;
    }
    say(await answer.text());
  } catch (trouble) { /* the desk does not answer: it is asked again */ }
  setTimeout(preview, 1000);
}
if (at('preview-state')) {
  at('previewed').hidden = true;
  preview();
}
