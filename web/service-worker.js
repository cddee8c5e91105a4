// Keeps the page for use without a network. All its files are of one version, which web/build writes here.
const VERSION = 'unbuilt';
const FILES = ['./', './gamow-web.js', './gamow-web_bg.wasm', './gamow-worker.js', './icon.png', './manifest.webmanifest', './stereoscope.js'];

addEventListener('install', event => {
    event.waitUntil(caches.open(VERSION).then(cache => cache.addAll(FILES)));
});

addEventListener('activate', event => {
    const outdated = names => names.filter(name => name !== VERSION).map(name => caches.delete(name));
    event.waitUntil(caches.keys().then(names => Promise.all(outdated(names))));
});

addEventListener('fetch', event => {
    if (event.request.method !== 'GET') return;
    const kept = caches.open(VERSION).then(cache => cache.match(event.request, { ignoreSearch: true }));
    event.respondWith(kept.then(response => response ?? fetch(event.request)));
});
