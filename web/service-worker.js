// Keeps the page for use without a network. All its files are of one version, which web/build writes here.
const VERSION = 'unbuilt';
const FILES = [
    './', './gamow-unpack.js', './gamow-unpack_bg.wasm', './gamow-web.js', './gamow-web.wasm.lzma', './gamow-worker.js',
    './icon.png', './LICENSES-THIRD-PARTY.txt', './manifest.webmanifest', './page.js', './stereoscope.js',
    // The pictures of the cards, which web/build writes here.
    ...[],
];
// Caches belong to an origin, which may have other pages with their own.
const OWN = `gamow ${new URL(registration.scope).pathname} `;
const CACHE = OWN + VERSION;

// All files are kept or none, and each as the server has it now: of what the browser's own cache has, the server
// says whether it is the same.
async function install() {
    const cache = await caches.open(CACHE);
    try {
        await cache.addAll(FILES.map(file => new Request(file, { cache: 'no-cache' })));
    } catch (error) {
        await caches.delete(CACHE);
        throw error;
    }
}

async function deleteOutdated() {
    const outdated = (await caches.keys()).filter(name => name.startsWith(OWN) && name !== CACHE);
    await Promise.all(outdated.map(name => caches.delete(name)));
}

addEventListener('install', event => event.waitUntil(install()));
addEventListener('activate', event => event.waitUntil(deleteOutdated()));
addEventListener('fetch', event => {
    if (event.request.method !== 'GET') return;
    const kept = caches.open(CACHE).then(cache => cache.match(event.request, { ignoreSearch: true }));
    event.respondWith(kept.then(response => response ?? fetch(event.request)));
});
