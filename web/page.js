// The page around the program: loads it, and shows what keeps it from running.

// A page that GitHub hands out belongs to the repository of its name.
const [owner] = location.hostname.split('.github.io'), [, name] = location.pathname.split('/');
if (owner !== location.hostname && name) {
    const [source, documentation] = document.querySelectorAll('#links a');
    source.href = `https://github.com/${owner}/${name}`;
    documentation.href = `${source.href}/tree/HEAD/docs`;
    document.documentElement.dataset.source = source.href;
    document.getElementById('links').hidden = false;
}

const loading = document.getElementById('loading'), problem = document.getElementById('problem');

// The first problem stays: others follow from it.
function showProblem(text) {
    if (!problem.hidden) return;
    const sentence = document.createElement('p'), reload = document.createElement('button');
    sentence.textContent = text;
    reload.textContent = 'Load the page again';
    reload.onclick = () => location.reload();
    problem.replaceChildren(sentence, reload);
    problem.hidden = false;
    loading.hidden = true;
    document.getElementById('mirror').hidden = true;
}
addEventListener('gamow-problem', () => showProblem(document.documentElement.dataset.problem));
// A canvas on which nothing was drawn is transparent.
addEventListener('gamow-painted', () => {
    const pen = new OffscreenCanvas(1, 1).getContext('2d'), canvas = document.getElementById('gamow');
    if (canvas.width > 0 && canvas.height > 0) pen.drawImage(canvas, 0, 0, 1, 1);
    document.documentElement.dataset.painted = pen.getImageData(0, 0, 1, 1).data[3] > 0;
});
addEventListener('gamow-shown', () => { loading.hidden = true; });

// Whatever else ends the program, such as too little memory.
for (const event of ['error', 'unhandledrejection']) {
    addEventListener(event, ({ error, reason }) => {
        if ((error ?? reason) instanceof WebAssembly.RuntimeError) {
            showProblem('The program has stopped. What was shown is in the address. The browser’s console has the details.');
        }
    });
}
// The window itself is not told of it, and asks for less of the graphics when the page is loaded again.
document.getElementById('gamow').addEventListener('webglcontextlost', () => {
    try {
        sessionStorage.setItem('gamow/graphics-lost', 'yes');
    } catch (error) {
        console.warn(error);
    }
    showProblem('The browser has taken the graphics away. What was shown is in the address.');
});

// The text of which the browser has refused a copy.
addEventListener('gamow-text', () => {
    const copy = document.getElementById('copy'), text = copy.querySelector('textarea');
    text.value = document.documentElement.dataset.text;
    copy.hidden = false;
    text.focus();
    text.select();
    const close = () => {
        copy.hidden = true;
        document.getElementById('gamow').focus();
    };
    copy.querySelector('button').onclick = close;
    copy.onkeydown = event => {
        // The keys are not for the window below.
        event.stopPropagation();
        if (event.key === 'Escape') close();
    };
});

// The bytes of the packed program, which web/build writes here.
const TOTAL = 0;

function showProgress(bytes) {
    const megabytes = number => (number / 1e6).toFixed(1), bar = document.getElementById('bar');
    const total = TOTAL > 0 ? ` of ${megabytes(TOTAL)}` : '';
    document.getElementById('progress').textContent = `Loading… ${megabytes(bytes)}${total} MB`;
    if (TOTAL > 0) [bar.max, bar.value] = [TOTAL, bytes];
}

// The bytes of a file. How many have come is told to `come`.
async function loaded(path, come = () => {}) {
    const response = await fetch(path);
    if (!response.ok) throw new Error(`${path}: ${response.status} ${response.statusText}`);
    let bytes = 0;
    const counted = new TransformStream({
        transform(chunk, controller) {
            bytes += chunk.byteLength;
            come(bytes);
            controller.enqueue(chunk);
        },
    });
    return new Uint8Array(await new Response(response.body.pipeThrough(counted)).arrayBuffer());
}

// The program, which comes packed. Its packed bytes, and what unpacks them, are forgotten then.
async function program() {
    // How much has come is shown, in place of silence on a slow line.
    const packed = loaded('gamow-web.wasm.lzma', showProgress);
    const { default: start, unpacked } = await import('./gamow-unpack.js');
    await start({ module_or_path: loaded('gamow-unpack_bg.wasm') });
    return unpacked(await packed);
}

try {
    const [{ default: start }, module] = await Promise.all([import('./gamow-web.js'), program()]);
    await start({ module_or_path: module });
} catch (error) {
    console.error(error);
    showProblem(`The program could not be loaded or started (${error.message ?? error}). It needs a browser of 2023 or later, with WebAssembly SIMD.`);
}

// Has the browser keep the page for use without a network; where it cannot, the page says so for a while.
async function keepPage() {
    const showNote = problem => {
        const note = document.getElementById('note');
        note.textContent = `The page could not be kept for use without a network (${problem}).`;
        note.hidden = false;
        note.onclick = () => { note.hidden = true; };
        setTimeout(note.onclick, 20_000);
    };
    try {
        const registration = await navigator.serviceWorker.register('./service-worker.js', { updateViaCache: 'none' });
        const worker = registration.installing;
        worker?.addEventListener('statechange', () => {
            if (worker.state === 'redundant' && !registration.active) showNote('its files could not be fetched');
        });
    } catch (error) {
        console.warn(error);
        showNote(error.message ?? error);
    }
}
if ('serviceWorker' in navigator && isSecureContext) keepPage();
