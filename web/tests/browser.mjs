// Opens the page in a browser without a screen, and gives the tests what they need to drive it.
import { spawn, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { createServer } from 'node:http';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import puppeteer from 'puppeteer-core';

const SITE = process.env.SITE ?? 'target/page';
const TYPES = {
    '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm', '.png': 'image/png',
    '.txt': 'text/plain', '.webmanifest': 'application/manifest+json',
};
export const WEBGL = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
// Without a screen Chromium has no surface that WebGPU could draw on: it loses the device, or shows nothing.
export const WEBGPU = [
    '--enable-unsafe-webgpu', '--enable-features=Vulkan', '--use-vulkan=swiftshader', '--use-angle=swiftshader',
    '--disable-vulkan-surface', '--ignore-gpu-blocklist',
];
export const NOTHING = ['--disable-gpu', '--disable-webgl', '--disable-3d-apis'];
// A slow machine without a GPU takes its time.
const PATIENCE = 180_000;

export const sleep = milliseconds => new Promise(done => setTimeout(done, milliseconds));

// Returns what `find` finds, once that is something.
export async function eventually(what, find, patience = PATIENCE) {
    const end = Date.now() + patience;
    for (;;) {
        const found = await find();
        if (found) return found;
        if (Date.now() > end) throw new Error(`${what}: nothing in ${patience / 1000} s`);
        await sleep(100);
    }
}

// Hands out the files of the page as any web server does: not again where a browser has what it would get.
// `sent` counts how often a file was.
export async function serve() {
    const sent = {};
    const server = createServer((request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
        const file = join(SITE, path.endsWith('/') ? `${path}index.html` : path);
        if (!existsSync(file)) return response.writeHead(404).end();
        const bytes = readFileSync(file), digest = `"${createHash('sha256').update(bytes).digest('hex')}"`;
        if (request.headers['if-none-match'] === digest) return response.writeHead(304).end();
        sent[path] = (sent[path] ?? 0) + 1;
        response.writeHead(200, { 'Content-Type': TYPES[extname(file)] ?? 'application/octet-stream', ETag: digest });
        response.end(bytes);
    });
    await new Promise(done => server.listen(0, '127.0.0.1', done));
    return { address: `http://localhost:${server.address().port}/`, sent, close: () => server.close() };
}

// Whether there are screens in software, those of Xvfb.
export const hasScreens = () => spawnSync('Xvfb', ['-help']).error === undefined;

// A screen that nobody sees.
export async function openScreen() {
    const server = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1500x1100x24'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
    const number = await new Promise((found, failed) => {
        server.stdio[3].once('data', found);
        server.once('exit', () => failed(new Error('Xvfb has ended')));
    });
    return { name: `:${String(number).trim()}`, close: () => server.kill() };
}

// A browser with these graphics, on a screen if one is given.
export async function launch({ graphics = WEBGL, scale = 1, screen } = {}) {
    return puppeteer.launch({
        executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
        headless: !screen,
        env: screen ? { ...process.env, DISPLAY: screen.name } : process.env,
        defaultViewport: { width: 1280, height: 800, deviceScaleFactor: 0 },
        args: [
            '--no-sandbox', '--disable-dev-shm-usage', '--window-size=1400,1000', `--force-device-scale-factor=${scale}`, ...graphics,
        ],
        timeout: PATIENCE, protocolTimeout: 2 * PATIENCE,
    });
}

// Counts the answers of the page's workers, and keeps the tasks that held its thread for over 50 ms.
function countAnswers() {
    globalThis.answers = 0;
    globalThis.Worker = class extends Worker {
        constructor(...given) {
            super(...given);
            this.addEventListener('message', ({ data }) => { globalThis.answers += data.length === 2; });
        }
    };
    globalThis.longTasks = [];
    const note = list => globalThis.longTasks.push(...list.getEntries().map(entry => Math.round(entry.duration)));
    new PerformanceObserver(note).observe({ entryTypes: ['longtask'] });
}

// Gives the page a function that returns the levels of a PNG as base64.
function readPictures() {
    globalThis.pixelsOf = async picture => {
        // The page may fetch nothing but its own files.
        const bytes = Uint8Array.from(atob(picture), letter => letter.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height), pen = canvas.getContext('2d');
        pen.drawImage(bitmap, 0, 0);
        return pen.getImageData(0, 0, bitmap.width, bitmap.height).data;
    };
}

// A page with the window in it.
export class Window {
    constructor(page, address) {
        Object.assign(this, { page, address, problems: [] });
        page.on('pageerror', error => this.problems.push(`not caught: ${error.message}`));
        page.on('requestfailed', request => this.problems.push(`not loaded: ${request.url()}`));
        page.on('console', message => {
            // So Chromium says that a busy page has seen a touch late.
            const is_late = message.text().startsWith('Ignored attempt to cancel a touch');
            if (message.type() === 'error' && !is_late) this.problems.push(message.text());
        });
    }

    // Opens the page with this fragment of its address, in a profile of its own where each page first runs
    // `before`, and waits for the window.
    static async open(browser, address, fragment = '', before = () => {}) {
        const context = await browser.createBrowserContext();
        const page = await context.newPage();
        const window = new Window(page, address);
        window.folder = mkdtempSync(join(tmpdir(), 'gamow-'));
        const session = await page.createCDPSession();
        await session.send('Browser.setDownloadBehavior', {
            behavior: 'allow', downloadPath: window.folder, browserContextId: context.id,
        });
        await page.evaluateOnNewDocument(countAnswers);
        await page.evaluateOnNewDocument(readPictures);
        await page.evaluateOnNewDocument(before);
        await page.goto(address + fragment, { timeout: PATIENCE });
        await window.shown();
        return window;
    }

    async shown() {
        const is_shown = () => document.getElementById('loading').hidden;
        await this.page.waitForFunction(is_shown, { timeout: PATIENCE });
    }

    // The first problem that the page shows in place of the window.
    problem() {
        return this.page.evaluate(() => {
            const problem = document.getElementById('problem');
            return problem.hidden ? '' : problem.textContent;
        });
    }

    // The settings in the address.
    async settings() {
        const hash = await this.page.evaluate(() => location.hash);
        return new URLSearchParams(hash.slice(1));
    }

    // Whether the window says this to a screen reader.
    says(sentence) {
        return this.page.evaluate(sentence => document.getElementById('mirror').textContent.includes(sentence), sentence);
    }

    // Waits until the window has an element of this name.
    async has(name) {
        const isThere = name => document.querySelector(`#mirror [aria-label="${name}"]`) !== null;
        await eventually(name, () => this.page.evaluate(isThere, name));
    }

    // What is kept under this name, for the page in the root folder of its server.
    stored(name) {
        return this.page.evaluate(name => localStorage.getItem(`/:${name}`), name);
    }

    // Waits for these milliseconds, and for the frames in which the window answers: a busy machine takes
    // longer for them.
    async rest(milliseconds) {
        await sleep(milliseconds);
        await this.page.evaluate(async () => {
            for (let frame = 0; frame < 4; frame += 1) await new Promise(done => requestAnimationFrame(done));
        });
    }

    async press(...keys) {
        for (const key of keys.slice(0, -1)) await this.page.keyboard.down(key);
        await this.page.keyboard.press(keys.at(-1), { delay: 60 });
        for (const key of keys.slice(0, -1)) await this.page.keyboard.up(key);
        await this.rest(300);
    }

    // Asks for an action by its name, in the palette of commands.
    async act(name) {
        await this.press('Control', 'p');
        await this.has('Command');
        await this.page.keyboard.type(name, { delay: 30 });
        await this.rest(500);
        await this.press('Enter');
        await this.rest(500);
    }

    // Saves what this action does, under the proposed name or as `typed`, and returns the download.
    async saved(action, typed = '') {
        await this.act(action);
        await this.has('Path');
        if (typed) {
            await this.press('Control', 'a');
            await this.page.keyboard.type(typed);
            await this.rest(500);
        }
        await this.press('Enter');
        return await this.download();
    }

    async click(x, y) {
        await this.page.mouse.move(x, y);
        await this.rest(150);
        await this.page.mouse.down();
        await this.rest(80);
        await this.page.mouse.up();
    }

    async drag(from, to) {
        const at = part => from.map((start, i) => start + (to[i] - start) * part);
        await this.page.mouse.move(...from);
        await this.rest(150);
        await this.page.mouse.down();
        for (let step = 1; step <= 8; step += 1) {
            await this.page.mouse.move(...at(step / 8));
            await this.rest(60);
        }
        await this.page.mouse.up();
    }

    // Drops a file with this text onto the window.
    drop(name, text) {
        return this.page.evaluate(([name, text]) => {
            const dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File([text], name));
            const canvas = document.getElementById('gamow');
            for (const kind of ['dragenter', 'dragover', 'drop']) {
                const options = { dataTransfer, bubbles: true, cancelable: true, clientX: 300, clientY: 300 };
                canvas.dispatchEvent(new DragEvent(kind, options));
            }
        }, [name, text]);
    }

    // Chromium's accessibility tree, as a list: of each node that assistive technology finds its role, name,
    // value and properties.
    async tree() {
        this.session ??= await this.page.createCDPSession();
        const { nodes } = await this.session.send('Accessibility.getFullAXTree');
        return nodes.filter(node => !node.ignored).map(node => ({
            element: node.backendDOMNodeId, role: node.role.value, name: node.name?.value ?? '', value: node.value?.value,
            description: node.description?.value ?? '',
            ...Object.fromEntries((node.properties ?? []).map(({ name, value }) => [name, value.value])),
        }));
    }

    // The first node of the tree with this role and a name like that, once there is one.
    node(role, name) {
        const isIt = node => node.role === role && name.test(node.name);
        return eventually(`${role} ${name}`, async () => (await this.tree()).find(isIt));
    }

    // Has the element of a node do something, as a screen reader has it.
    async actOn(node, action) {
        const { object } = await this.session.send('DOM.resolveNode', { backendNodeId: node.element });
        const { exceptionDetails } = await this.session.send('Runtime.callFunctionOn', {
            objectId: object.objectId, functionDeclaration: `function () { (${action})(this); }`,
        });
        if (exceptionDetails) throw new Error(exceptionDetails.exception.description);
        await this.rest(300);
    }

    // Presses Tab until a node like this has the focus, and returns it.
    async tabTo(role, name) {
        for (let key = 0; key < 150; key += 1) {
            await this.press('Tab');
            const focused = await this.focused();
            if (focused?.role === role && name.test(focused.name)) return focused;
        }
        throw new Error(`no Tab leads to ${role} ${name}`);
    }

    // The node that a screen reader takes to have the focus: that to which the window's canvas points.
    async focused() {
        const element = await this.page.evaluate(() => {
            const canvas = document.getElementById('gamow');
            return document.activeElement === canvas ? canvas.getAttribute('aria-activedescendant') : document.activeElement.id;
        });
        if (!element) return undefined;
        const { root } = await this.session.send('DOM.getDocument');
        const { nodeId } = await this.session.send('DOM.querySelector', { nodeId: root.nodeId, selector: `[id="${element}"]` });
        const { node } = await this.session.send('DOM.describeNode', { nodeId });
        return (await this.tree()).find(({ element }) => element === node.backendNodeId);
    }

    // The name and the bytes of the next download.
    async download() {
        const name = await eventually('a download', () => readdirSync(this.folder).find(name => !name.endsWith('.crdownload')));
        const bytes = readFileSync(join(this.folder, name));
        rmSync(join(this.folder, name));
        return { name, bytes };
    }

    // The number of different colours in a part of the window, of every fourth pixel.
    async colours(clip) {
        return this.coloursOf(await this.page.screenshot({ type: 'png', clip, encoding: 'base64' }));
    }

    // The number of different colours in a PNG as base64, of every fourth pixel.
    coloursOf(picture) {
        return this.page.evaluate(async picture => {
            const data = await pixelsOf(picture), seen = new Set();
            for (let i = 0; i < data.length; i += 16) seen.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
            return seen.size;
        }, picture);
    }

    // The mean difference of two pictures of one size, PNG as base64, levels of 255.
    difference(pictures) {
        return this.page.evaluate(async pictures => {
            const [a, b] = await Promise.all(pictures.map(pixelsOf));
            return a.reduce((sum, level, i) => sum + Math.abs(level - b[i]), 0) / a.length;
        }, pictures);
    }

    // The middle of the element of this name, which the window mirrors for screen readers.
    async middle(name) {
        await this.has(name);
        return this.page.evaluate(name => {
            const { x, y, width, height } = document.querySelector(`#mirror [aria-label="${name}"]`).getBoundingClientRect();
            return [x + width / 2, y + height / 2];
        }, name);
    }

    // The number of pictures that workers have drawn.
    answers() {
        return this.page.evaluate(() => globalThis.answers);
    }

    // The milliseconds of the tasks that held the page's thread for over 50 ms since the last call, the
    // longest first.
    longTasks() {
        return this.page.evaluate(() => globalThis.longTasks.splice(0).sort((a, b) => b - a));
    }

    // Closes the page; it must have had no problem.
    async close() {
        rmSync(this.folder, { recursive: true, force: true });
        await this.page.browserContext().close();
        if (this.problems.length > 0) throw new Error(`problems in the console: ${this.problems.join('; ')}`);
    }
}
