// The page in Chromium, by WebGL and once by WebGPU, both in software.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { NOTHING, WEBGPU, Window, eventually, hasScreens, launch, openScreen, serve } from './browser.mjs';

// The desktop program, for its numbers.
const GAMOW = process.env.GAMOW ?? 'target/release/gamow';
// Places in a window of 1280 by 800 points: both eyes' views, the speed slider, a point of a globe, the
// button that stops what is being saved.
const VIEWS = { x: 4, y: 64, width: 938, height: 240 };
const SPEED = { from: [1019, 78], to: [1150, 78] };
const POINT = [200, 150];
const STOP = [738, 727];
// In one of 360 by 740 points: the first lesson's button on the start page, its first answer, and the button
// that predicts.
const PHONE = [[180, 368], [60, 594], [300, 675]];
// In one of 740 by 360 points: the button that closes the stereoscope's menu.
const LOOK = [232, 281];

let server, browser;
before(async () => {
    server = await serve();
    browser = await launch();
});
after(async () => {
    await browser?.close();
    server?.close();
});

// Opens the window, has `use` use it, and closes it; the console must have had no errors.
async function inWindow(fragment, use) {
    const window = await Window.open(browser, server.address, fragment);
    await use(window);
    assert.equal(await window.problem(), '');
    await window.close();
}

test('the first picture comes, and an address is what is shown', () => inWindow('#beta=0.9&scene=globe', async window => {
    await eventually('a picture', async () => await window.colours(VIEWS) > 200);
    await window.press('ArrowUp');
    await eventually('another speed in the address', async () => (await window.settings()).get('beta') !== '0.9');
    const settings = await window.settings();
    assert.equal(settings.get('scene'), 'globe');
    assert.ok(Number(settings.get('beta')) > 0.9);
}));

test('the speed slider is dragged, and a point is clicked', () => inWindow('#scene=globe&beta=0.5', async window => {
    await window.drag(SPEED.from, SPEED.to);
    await eventually('the dragged speed', async () => Number((await window.settings()).get('beta')) !== 0.5);
    // Clicks are repeated: where a frame takes longer than 0.8 s, a press that it parts from its release is
    // no click.
    await eventually('the clicked point', async () => {
        await window.click(...POINT);
        await window.rest(1000);
        return (await window.settings()).get('point');
    });
}));

test('a finger taps a point, and drags the speed', () => inWindow('#scene=globe&beta=0.5', async window => {
    await window.page.touchscreen.tap(...POINT);
    await eventually('the tapped point', async () => (await window.settings()).get('point'));
    const finger = await window.page.touchscreen.touchStart(...SPEED.from);
    for (let x = SPEED.from[0]; x <= SPEED.to[0]; x += 16) {
        await finger.move(x, SPEED.from[1]);
        await window.rest(60);
    }
    await finger.end();
    await eventually('the dragged speed', async () => Number((await window.settings()).get('beta')) > 0.6);
}));

test('a newcomer makes the first prediction on a phone, by touch', () => inWindow('', async window => {
    await window.page.setViewport({ width: 360, height: 740, deviceScaleFactor: 0 });
    await window.rest(1500);
    // Taps are repeated: one that comes before the window is ready for it is lost.
    const tapped = (what, places, found) => eventually(what, async () => {
        for (const [x, y] of places) {
            await window.page.touchscreen.tap(x, y);
            await window.rest(2000);
        }
        return found();
    });
    const [begin, choice, predict] = PHONE;
    await tapped('the lesson', [begin], async () => (await window.settings()).get('lesson') === 'rods');
    const answers = await tapped('an answer', [choice, predict], () => window.stored('gamow/answers/rods.json'));
    assert.match(answers, /Choice|choice/);
}));

test('a phone in a viewer shows what is around it as it is turned', () => inWindow('#stereoscope&scene=street&beta=0.6&refine=off', async window => {
    const { page } = window;
    await page.setViewport({ width: 740, height: 360, deviceScaleFactor: 0, isLandscape: true });
    const session = await page.createCDPSession();
    const turn = (alpha, beta, gamma) => session.send('DeviceOrientation.setDeviceOrientationOverride', { alpha, beta, gamma });
    // On its side and upright, towards the north, with the top of what it shows at its right edge.
    await turn(90, 0, -90);
    const told = () => page.evaluate(() => document.documentElement.dataset.turned ?? '');
    await eventually('the orientation', async () => await told() === '90 0 -90 90');
    await window.rest(1500);
    await page.touchscreen.tap(...LOOK);
    await window.rest(1500);
    const picture = async () => {
        await window.rest(2500);
        return page.screenshot({ type: 'png', encoding: 'base64' });
    };
    await eventually('two pictures', async () => await window.colours({ x: 150, y: 20, width: 440, height: 300 }) > 200);
    const ahead = await picture();
    await turn(0, 0, -90);
    const right = await picture();
    assert.notEqual(right, ahead);
    await turn(90, 0, -60);
    const down = await picture();
    assert.notEqual(down, ahead);
    assert.notEqual(down, right);
    await turn(90, 0, -90);
    assert.equal(await picture(), ahead);
    assert.ok((await page.evaluate(() => location.hash)).includes('stereoscope'));
    await window.press('Escape');
    await eventually('the stereoscope is left', async () => !(await page.evaluate(() => location.hash)).includes('stereoscope'));
    // What was shown is as it was.
    const { time, ...settings } = Object.fromEntries(await window.settings());
    assert.ok(Number.isFinite(Number(time)));
    assert.deepEqual(settings, { beta: '0.6', refine: 'off' });
    assert.equal(await page.evaluate(() => document.documentElement.dataset.stereoscope), 'off');
}));

// Columns of a table whose cells hold no commas.
const table = text => {
    const [head, ...rows] = text.trimEnd().split(/\r?\n/).map(line => line.split(','));
    return rows.map(row => Object.fromEntries(head.map((name, i) => [name, row[i]])));
};

test('keys walk, each its own way', () => inWindow('#scene=street&refine=off', async window => {
    await window.press('i');
    await eventually('a ride', async () => (await window.settings()).get('ride') === 'coast');
    for (const [key, push] of [['w', '0.25'], ['a', '0:0.25'], ['s', '-0.25'], ['d', '0:-0.25']]) {
        await window.page.keyboard.down(key);
        await window.rest(600);
        await window.page.keyboard.up(key);
        // The last leg but for the coasting between two.
        await eventually(`a push by ${key}`, async () => {
            const legs = (await window.settings()).get('ride').split(',').map(leg => leg.split('@')[1]);
            return legs.filter(leg => leg !== '0').at(-1) === push;
        });
    }
}));

test('two thumbs ride: one holds a pedal, the other looks around', async () => {
    const window = await Window.open(browser, server.address, '#scene=street&ride=coast&ride-from=-20&layout=left&refine=off', coarse);
    await window.page.setViewport({ width: 360, height: 740, deviceScaleFactor: 0 });
    await window.rest(2500);
    const legs = async () => (await window.settings()).get('ride') ?? '';
    const gaze = async () => (await window.settings()).get('gaze') ?? '';
    const before = await gaze();
    const pedal = await window.page.touchscreen.touchStart(...await window.middle('Pedal: hold'));
    await eventually('a push', async () => (await legs()).includes('@0.25'));
    const other = await window.page.touchscreen.touchStart(150, 180);
    for (let x = 150; x <= 210; x += 10) {
        await other.move(x, 180);
        await window.rest(60);
    }
    await other.end();
    await eventually('another gaze', async () => await gaze() !== before);
    await pedal.end();
    const brake = await window.page.touchscreen.touchStart(...await window.middle('Brake: hold'));
    await eventually('the brake', async () => (await legs()).includes('@-0.25'));
    await brake.end();
    await window.close();
});

test('the numbers of a curve are those of the desktop, digit by digit', { skip: !existsSync(GAMOW) && `no ${GAMOW}` }, () => {
    return inWindow('#scene=cube&beta=0.9&point=0,6,0.5', async window => {
        const { name, bytes } = await window.saved('save the plots as a table');
        assert.match(name, /\.csv$/);
        const rows = table(bytes.toString());
        assert.ok(rows.length > 50, `${rows.length} rows`);
        const lines = rows.map(row => [0.9, row.d, 6, 0.5, 0, row.T].join(','));
        const desktop = execFileSync(GAMOW, ['eval'], { input: `beta,d,y,z,x0,T\n${lines.join('\n')}\n` });
        const expected = table(desktop.toString());
        const angles = ({ dphi, dtheta }) => `${dphi} ${dtheta}`;
        assert.deepEqual(rows.map(angles), expected.map(angles));
    });
});

test('a lesson is predicted, revealed and remembered', () => inWindow('#lesson=rods', async window => {
    await window.rest(1500);
    await window.press('3');
    await window.press('PageDown');
    const answers = await eventually('an answer', () => window.stored('gamow/answers/rods.json'));
    assert.match(answers, /rods/);
    await window.rest(6000);
    await window.press('1');
    assert.equal((await window.settings()).get('lesson'), 'rods');
    await window.page.reload();
    await window.shown();
    assert.equal((await window.settings()).get('lesson'), 'rods');
    assert.match(await window.stored('gamow/answers/rods.json'), /rods/);
}));

// The roles of what somebody can do something with.
const ACTIVE = new Set(['button', 'checkbox', 'combobox', 'link', 'radio', 'slider', 'spinbutton', 'switch', 'textbox']);

// What a screen reader says in place of the slider's number. The protocol has no field for it.
const speedSaid = window => window.page.evaluate(() => (
    document.querySelector('#mirror [aria-label^="Speed"]').getAttribute('aria-valuetext')
));

test('a screen reader finds the window: names, roles, values and places', async t => {
    for (const fragment of ['#start', '#scene=globe&beta=0.9', '#lesson=rods', '#scene=street&beta=0.6&plot=fit']) {
        await inWindow(fragment, async window => {
            await window.rest(1500);
            const nodes = await window.tree(), active = nodes.filter(({ role }) => ACTIVE.has(role));
            t.diagnostic(`${fragment}: ${nodes.length} nodes, ${active.length} of them to be used`);
            assert.ok(active.length >= 15, `${active.length}`);
            assert.deepEqual(active.filter(({ name }) => name.trim() === ''), []);
            assert.ok(nodes.some(({ role, name }) => role === 'application' && /Gamow/.test(name)));
        });
    }
    await inWindow('#scene=globe&beta=0.9', async window => {
        const speed = await window.node('slider', /^Speed/);
        assert.ok(speed.value > 0 && speed.value < 1, `${speed.value}`);
        assert.equal(await speedSaid(window), '0.900');
        const view = await window.node('image', /^Left eye view/);
        assert.ok(view.description.length > 20, view.description);
        const place = await window.page.evaluate(() => {
            const { x, y, width, height } = document.querySelector('#mirror [aria-label^="Speed"]').getBoundingClientRect();
            return [x, y, x + width, y + height];
        });
        const [x0, y0, x1, y1] = place;
        assert.ok(x0 <= SPEED.from[0] && SPEED.to[0] <= x1 && y0 <= SPEED.from[1] && SPEED.to[1] <= y1, `${place}`);
        // A mouse finds the window all the same.
        assert.equal(await window.page.evaluate(([x, y]) => document.elementFromPoint(x, y).id, SPEED.from), 'gamow');
    });
    await inWindow('#start', async window => {
        await window.node('button', /^First lesson/);
        assert.equal(await window.page.evaluate(() => document.documentElement.lang), 'en');
    });
});

test('the speed slider is moved by a screen reader', () => inWindow('#scene=globe&beta=0.5', async window => {
    const speed = await window.node('slider', /^Speed/);
    const beta = async () => Number((await window.settings()).get('beta'));
    await window.actOn(speed, slider => {
        slider.value = '0.8';
        slider.dispatchEvent(new Event('input', { bubbles: true }));
    });
    await eventually('the speed that was asked for', async () => await beta() === 0.8);
    assert.equal(await speedSaid(window), '0.800');
    // The focus that it is given is the window's, which takes the keys.
    await window.actOn(speed, slider => slider.focus());
    await window.press('ArrowLeft');
    await eventually('a lower speed', async () => await beta() < 0.8);
    assert.equal((await window.focused()).name, speed.name);
}));

test('a lesson is gone through by a screen reader and keys', () => inWindow('#lesson=ride-gate', async window => {
    const said = () => window.page.evaluate(() => (
        [...document.querySelectorAll('#mirror [aria-live=polite]')].map(part => part.textContent).join(' ')
    ));
    const press = (role, name) => window.node(role, name).then(node => window.actOn(node, element => element.click()));
    const step = async (question, prediction, observation, explanation, choose) => {
        await eventually(question, async () => question.test(await said()));
        await choose('radio', prediction);
        assert.equal((await window.node('radio', prediction)).checked, 'true');
        await choose('button', /^Predict/);
        await press('button', /^Show the end/);
        await choose('radio', observation);
        await eventually('praise', async () => /that is what happened/.test(await said()));
        await choose('button', /^Next$/);
        await eventually(explanation, async () => explanation.test(await said()));
        await choose('button', /^Next$/);
    };
    await step(/What do you see of it/, /still ahead/, /in the picture, all of it/, /you ride into it/, press);
    const byKeys = async (role, name) => {
        await window.tabTo(role, name);
        await window.press(' ');
    };
    await step(/How far inside/, /6 units/, /about 6/, /already/, byKeys);
    await eventually('the end', async () => /Even inside the gate/.test(await said()));
    const answers = await window.stored('gamow/answers/ride-gate.json');
    assert.match(answers, /ride-gate/);
    await window.node('button', /^Start over/);
}));

test('a link leads to the same state', () => inWindow('#beta=0.99&scene=wheel&colour=glowing', async window => {
    await window.press('ArrowRight');
    await window.rest(2500);
    const link = await window.page.evaluate(() => location.hash);
    const other = await Window.open(browser, server.address, link);
    await other.press('ArrowUp');
    await other.press('ArrowDown');
    await window.rest(2500);
    const settings = Object.fromEntries(await other.settings());
    assert.deepEqual(settings, Object.fromEntries(new URLSearchParams(link.slice(1))));
    await other.close();
}));

test('another fragment is followed', () => inWindow('#beta=0.6', async window => {
    await window.page.evaluate(() => { location.hash = '#scene=train&beta=0.8'; });
    await eventually('the train', async () => {
        // A key that comes before the train is there changes the speed of what it takes the place of.
        await window.press('ArrowUp');
        await window.rest(1200);
        const settings = await window.settings();
        return settings.get('scene') === 'train' && Number(settings.get('beta')) > 0.8;
    });
}));

// The message of the window is drawn, not text of the page: what is shown is seen by the address.
const hashOf = window => window.page.evaluate(() => location.hash);

test('a link that is followed leaves neither the start page nor a lesson on top', async () => {
    await inWindow('#start', async window => {
        await window.page.evaluate(() => { location.hash = '#scene=train&beta=0.8'; });
        // The speed is changed by keys only where no page lies over the window.
        await eventually('the train alone', async () => {
            await window.press('ArrowUp');
            await window.rest(1200);
            const settings = await window.settings();
            return settings.get('scene') === 'train' && Number(settings.get('beta')) > 0.8 && !settings.has('start');
        });
    });
    await inWindow('#lesson=rods', async window => {
        await window.page.evaluate(() => { location.hash = '#scene=globe&beta=0.7'; });
        await eventually('the globe alone', async () => {
            await window.press('ArrowUp');
            await window.rest(1200);
            const settings = await window.settings();
            return settings.get('scene') === 'globe' && Number(settings.get('beta')) > 0.7 && !settings.has('lesson');
        });
    });
});

test('Back and Forward walk the start page, lessons and presets', () => inWindow('#scene=globe&beta=0.7', async window => {
    const { page } = window;
    const entries = () => page.evaluate(() => history.length);
    const first = await entries();
    await window.press('ArrowUp');
    await eventually('a speed', async () => Number((await window.settings()).get('beta')) > 0.7);
    assert.equal(await entries(), first, 'a change of speed is no entry');
    const state = await hashOf(window);
    await window.press('s');
    await eventually('the start page', async () => /^#start/.test(await hashOf(window)));
    await window.rest(1500);
    await page.evaluate(() => { location.hash = '#lesson=rods'; });
    await window.rest(2500);
    assert.equal(await hashOf(window), '#lesson=rods');
    assert.equal(await entries(), first + 2);
    await page.evaluate(() => history.back());
    await eventually('the start page', async () => /^#start/.test(await hashOf(window)));
    await window.rest(1500);
    await page.evaluate(() => history.back());
    await eventually('the state', async () => await hashOf(window) === state);
    // It stays, and can be changed.
    await window.rest(2500);
    assert.equal(await hashOf(window), state);
    await page.evaluate(() => history.go(2));
    await eventually('the lesson', async () => await hashOf(window) === '#lesson=rods');
    await window.rest(2500);
    assert.equal(await hashOf(window), '#lesson=rods');
    assert.equal(await entries(), first + 2);
}));

// How a phone answers, whose main way to point is a finger.
const coarse = () => {
    const { matchMedia } = globalThis;
    globalThis.matchMedia = query => query === '(pointer: coarse)' ? { matches: true } : matchMedia.call(globalThis, query);
};

test('the first swipe of a finger scrolls', async () => {
    const window = await Window.open(browser, server.address, '#start', coarse);
    await window.page.setViewport({ width: 360, height: 740, deviceScaleFactor: 0 });
    await window.rest(2500);
    const picture = () => window.page.screenshot({ type: 'png', encoding: 'base64', clip: { x: 20, y: 500, width: 320, height: 200 } });
    const before = await picture();
    await window.rest(1000);
    assert.equal(await picture(), before, 'nothing moves by itself there');
    const finger = await window.page.touchscreen.touchStart(180, 650);
    for (let y = 640; y >= 350; y -= 30) {
        await finger.move(180, y);
        await window.rest(30);
    }
    await finger.end();
    await eventually('what is further down', async () => await picture() !== before, 20_000);
    await window.close();
});

test('a text that the browser does not copy is shown selected', async () => {
    const refused = () => {
        Clipboard.prototype.writeText = () => Promise.reject(new DOMException('refused', 'NotAllowedError'));
    };
    const window = await Window.open(browser, server.address, '#scene=rods&beta=0.7&refine=off', refused);
    await window.act('copy a link');
    await eventually('the text', () => window.page.evaluate(() => !document.getElementById('copy').hidden));
    const selected = await window.page.evaluate(() => {
        const { value, selectionStart, selectionEnd } = document.querySelector('#copy textarea');
        return value.slice(selectionStart, selectionEnd);
    });
    assert.ok(selected.endsWith('#scene=rods&beta=0.7&refine=off') || /#.*beta=0.7/.test(selected), selected);
    await window.page.keyboard.press('Escape');
    assert.ok(await window.page.evaluate(() => document.getElementById('copy').hidden));
    await window.close();
});

test('a finger shares a link by the system, which says whether it has a sheet for that', async () => {
    const phone = () => {
        const matches = globalThis.matchMedia;
        globalThis.matchMedia = query => (query === '(pointer: coarse)' ? { matches: true } : matches.call(globalThis, query));
        navigator.share = async ({ url }) => { globalThis.shared = url; };
    };
    const window = await Window.open(browser, server.address, '#scene=rods&beta=0.7&refine=off', phone);
    await window.act('copy a link');
    const shared = await eventually('the shared link', () => window.page.evaluate(() => globalThis.shared));
    assert.match(shared, /#.*beta=0.7/);
    assert.ok(await window.page.evaluate(() => document.getElementById('copy').hidden));
    await window.close();
});

test('while the page loads it asks the first question, and shows how much has come', async () => {
    const page = await browser.newPage();
    await page.evaluateOnNewDocument(() => {
        globalThis.shares = [];
        new MutationObserver(() => {
            const bar = document.getElementById('bar');
            if (bar?.max > 1) globalThis.shares.push(bar.value / bar.max);
        }).observe(document, { subtree: true, childList: true, attributes: true });
    });
    await page.goto(server.address);
    await page.waitForFunction(() => document.getElementById('loading').hidden, { timeout: 180_000 });
    const { words, image, shares, language, title } = await page.evaluate(() => ({
        words: document.getElementById('loading').textContent,
        image: document.querySelector('#loading img').naturalWidth,
        shares: globalThis.shares,
        language: document.documentElement.lang,
        title: document.querySelector('meta[property="og:title"]').content,
    }));
    assert.match(words, /first question/);
    assert.doesNotMatch(words, /cargo/);
    assert.equal(image, 320);
    assert.equal(shares.at(-1), 1);
    assert.equal(language, 'en');
    assert.match(title, /Gamow/);
    await page.close();
});

test('the window has a name and a role for screen readers', () => inWindow('#scene=globe', async window => {
    const tree = await window.page.accessibility.snapshot({ interestingOnly: false });
    const named = node => [node, ...(node.children ?? []).flatMap(named)].filter(({ name }) => /^Gamow: what/.test(name ?? ''));
    assert.ok(named(tree).some(({ role }) => role === 'application'), JSON.stringify(named(tree).map(({ role, name }) => [role, name])));
}));

test('the page as one file opens from a disk, and works', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'gamow-packed-'));
    execFileSync('web/pack', [folder], { env: { ...process.env, VERSION: 'test' } });
    const window = await Window.open(browser, `file://${folder}/gamow-test-page.html`, '#scene=globe&beta=0.9');
    await eventually('a picture', async () => await window.colours(VIEWS) > 200);
    // The instances beside the page's thread, too.
    await eventually('a smoother picture', async () => await window.answers() >= 1);
    assert.equal(await window.problem(), '');
    rmSync(folder, { recursive: true });
    await window.close();
});

test('a scene is dropped, and a wrong one is refused', () => inWindow('#beta=0.6', async window => {
    await window.press('Escape');
    const ball = '[[object]]\nshape = "sphere"\ncentre = [0, 3, 1]\nradius = 0.5\n';
    await window.drop('mine.toml', `name = "Mine"\n${ball}`);
    const isNamed = async () => (await window.settings()).get('scene') === 'mine.toml';
    await eventually('the scene in the address', isNamed);
    assert.match((await window.saved('save the state')).bytes.toString(), /scene = "mine.toml"/);
    await window.drop('wrong.toml', 'name = "Wrong"\n');
    await eventually('what is wrong', () => window.says('wrong.toml'));
    assert.match((await window.saved('save the state')).bytes.toString(), /scene = "mine.toml"/);
    // The browser has kept the file.
    assert.ok(await isNamed());
    await window.page.reload();
    await window.shown();
    const state = (await window.saved('save the state')).bytes.toString();
    assert.match(state, /scene = "mine.toml"/);
    assert.match(state, /beta = 0.6/);
    await window.page.evaluate(() => localStorage.clear());
    await window.page.reload();
    await window.shown();
    await eventually('what is missing', () => window.says('that file is not here'));
}));

// Lesson rods, pupil Ada, one question that was not answered: base64url of version, postcard and CRC-32.
const ANSWERS = 'AQRyb2RzA0FkYQEA8HWjrw';

test('a link with answers is read, and a damaged one is refused', () => inWindow(`#answers=${ANSWERS}`, async window => {
    await eventually('whose answers', () => window.says('Ada'));
    await window.page.evaluate(token => { location.hash = `answers=${token}`; }, ANSWERS.replace('A', 'B'));
    await eventually('a damaged link', () => window.says('this link is damaged'));
}));

test('own data are there after a reload, and a page that has lost them says so and asks for them', () => inWindow('#scene=globe&beta=0.5&plot=fit&refine=off', async window => {
    const line = (_, i) => `${i / 10 - 3},0.2,${0.03 + 1e-3 * i},${0.02 + 1e-4 * i * i}`;
    await window.drop('my data.csv', ['T,d,dphi,dtheta', ...Array.from({ length: 60 }, line)].join('\n'));
    const isNamed = async () => (await window.settings()).get('data') === 'my data.csv';
    await eventually('the name of the table in the address', isNamed);
    assert.ok(await eventually('the table in the window', () => window.says('my data.csv')));
    assert.ok(!await window.says('is not here'));
    await window.page.reload();
    await window.shown();
    await eventually('the table that was kept', () => window.says('my data.csv is fitted as this browser has kept it'));
    assert.ok(await isNamed());
    await window.page.evaluate(() => localStorage.clear());
    await window.page.reload();
    await window.shown();
    await eventually('what is missing', () => window.says('my data.csv is not here'));
}));

// The text that a PNG keeps under this name.
const textInPng = (bytes, name) => {
    for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at)) {
        const chunk = bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at));
        if (bytes.toString('latin1', at + 4, at + 8) === 'iTXt' && chunk.toString('latin1').startsWith(`${name}\0`)) {
            return chunk.subarray(chunk.lastIndexOf(0) + 1).toString();
        }
    }
    return '';
};

test('a saved picture is that of the desktop, byte for byte', { skip: !existsSync(GAMOW) && `no ${GAMOW}` }, () => {
    return inWindow('#scene=rods&beta=0.7&renderer=reference', async window => {
        await window.press('Control', 's');
        await window.has('Path');
        await window.press('Enter');
        const { name, bytes } = await window.download();
        assert.equal(name, 'rods.png');
        const [, ...words] = textInPng(bytes, 'Parameters').split(' ');
        const drawn = join(window.folder, 'drawn.png');
        execFileSync(GAMOW, [...words, '--out', drawn]);
        assert.ok(bytes.equals(readFileSync(drawn)));
    });
});

test('workers make still views smoother', async t => {
    await inWindow('#scene=rods&beta=0.7', async window => {
        await window.longTasks();
        await eventually('two smoother pictures of each eye', async () => await window.answers() === 4);
        await window.rest(1000);
        t.diagnostic(`still views, tasks of over 50 ms: ${await window.longTasks()}`);
        assert.equal(window.page.workers().length, 2);
        // What is moved is drawn anew.
        await window.press('ArrowRight');
        await eventually('pictures of the next moment', async () => await window.answers() > 4);
    });
});

// A Wavefront OBJ of 45,000 triangles.
const hills = () => {
    const steps = [...Array(151).keys()];
    const height = (row, column) => (0.3 * Math.sin(row / 9) * Math.cos(column / 7)).toFixed(3);
    const corners = steps.flatMap(row => steps.map(column => `v ${row / 50} ${column / 50 + 2} ${height(row, column)}`));
    const faces = steps.slice(1).flatMap(row => steps.slice(1).map(column => {
        const corner = (row - 1) * 151 + column;
        return `f ${corner} ${corner + 1} ${corner + 152} ${corner + 151}`;
    }));
    return [...corners, ...faces].join('\n');
};

test("a fit, the figures of accuracy, a saved worksheet and a model are made beside the page's thread", async t => {
    const cases = [
        ['a model', '#scene=globe&refine=off', async window => {
            await window.press('Escape');
            await window.drop('hills.obj', hills());
            await eventually('a scene', async () => await window.answers() >= 1);
            assert.match((await window.saved('save the state')).bytes.toString(), /scene = "hills.obj"/);
        }],
        ['a fit', '#scene=globe&beta=0.5&plot=fit&refine=off', async window => {
            await eventually('a fit', async () => await window.answers() >= 1);
            await window.press('ArrowUp');
            await eventually('another fit', async () => await window.answers() >= 2);
        }],
        ['accuracy', '#scene=rods&beta=0.5&plot=accuracy&refine=off', async window => {
            await eventually('two methods', async () => await window.answers() >= 2);
        }],
        ['a worksheet', '#lesson=rods', async window => {
            const { name, bytes } = await window.saved('save the worksheet');
            assert.match(name, /worksheet\.html$/);
            assert.match(bytes.toString(), /<html/);
        }],
    ];
    for (const [name, fragment, use] of cases) {
        await inWindow(fragment, async window => {
            await window.rest(2000);
            await window.longTasks();
            await use(window);
            assert.ok(window.page.workers().length >= 1);
            t.diagnostic(`${name}, tasks of over 50 ms: ${await window.longTasks()}`);
        });
    }
});

test('a film is stopped at once, and another file is saved', () => inWindow('#scene=rods&renderer=reference&refine=off', async window => {
    await window.act('film');
    await window.press('Enter');
    await window.rest(3000);
    const before = window.page.workers().length;
    await window.click(...STOP);
    await eventually('a worker less', () => window.page.workers().length === before - 1);
    assert.equal((await window.saved('save the picture')).name, 'rods.png');
}));

test('curves and a film are downloaded, and a link is copied that opens the same', () => inWindow('#scene=rods&beta=0.7&refine=off', async window => {
    const { page } = window;
    const allowed = ['clipboard-read', 'clipboard-write', 'clipboard-sanitized-write'];
    await page.browserContext().overridePermissions(new URL(server.address).origin, allowed);
    const files = [
        ['save the plots as a drawing', '', /\.svg$/, /^<svg|^<\?xml/],
        ['film', '', /\.gif$/, /^GIF89a/],
        ['film of 10 s', 'rods.mp4', /^rods\.mp4$/, /^....ftyp/s],
    ];
    for (const [action, typed, name, begin] of files) {
        const file = await window.saved(action, typed);
        assert.match(file.name, name);
        assert.match(file.bytes.toString('latin1'), begin);
    }
    await window.act('copy a link');
    const copied = () => page.evaluate(() => navigator.clipboard.readText());
    const link = new URL(await eventually('a link on the clipboard', copied));
    assert.equal(link.origin, new URL(server.address).origin);
    const { beta, scene } = Object.fromEntries(new URLSearchParams(link.hash.slice(1)));
    assert.deepEqual([beta, scene], ['0.7', 'rods']);
    await window.act('copy the picture');
    const picture = await eventually('a picture on the clipboard', () => page.evaluate(async () => {
        for (const item of await navigator.clipboard.read()) {
            if (!item.types.includes('image/png')) continue;
            const bytes = new Uint8Array(await (await item.getType('image/png')).arrayBuffer());
            return btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(''));
        }
    }));
    assert.ok(await window.coloursOf(picture) > 200);
}));

test('the window is resized', () => inWindow('#scene=globe&beta=0.9', async window => {
    for (const [width, height] of [[800, 600], [1600, 1000]]) {
        await window.page.setViewport({ width, height, deviceScaleFactor: 0 });
        await window.rest(1500);
        const size = await window.page.evaluate(() => {
            const { width, height } = document.getElementById('gamow');
            return [width, height];
        });
        assert.deepEqual(size, [width, height]);
        assert.ok(await window.colours({ x: 20, y: 60, width: width - 40, height: height - 120 }) > 200);
    }
}));

test('a lost context is told in a sentence, and the state is in the address', async () => {
    const window = await Window.open(browser, server.address, '#beta=0.8');
    await window.page.evaluate(() => {
        const canvas = document.getElementById('gamow');
        canvas.getContext('webgl2').getExtension('WEBGL_lose_context').loseContext();
    });
    await eventually('a sentence', async () => /graphics/.test(await window.problem()));
    assert.equal((await window.settings()).get('beta'), '0.8');
    assert.equal(await window.page.evaluate(() => sessionStorage.getItem('gamow/graphics-lost')), 'yes');
    await Promise.all([window.page.waitForNavigation(), window.page.click('#problem button')]);
    await window.shown();
    assert.equal(await window.problem(), '');
    await window.page.browserContext().close();
});

test('a defect is told in a sentence, and the state is in the address', async () => {
    const window = await Window.open(browser, server.address, '#scene=globe&beta=0.8');
    await window.press('ArrowUp');
    await eventually('another speed in the address', async () => (await window.settings()).get('beta') !== '0.8');
    const state = (await window.settings()).toString();
    // Every frame asks for the time, and counts on an answer.
    await window.page.evaluate(() => Object.defineProperty(globalThis, 'performance', { value: undefined }));
    await window.page.mouse.move(300, 300);
    await eventually('a sentence', async () => /this is a defect/.test(await window.problem()));
    assert.equal((await window.settings()).toString(), state);
    assert.ok(window.problems.some(problem => /panicked at/.test(problem)), window.problems.join('; '));
    await Promise.all([window.page.waitForNavigation(), window.page.click('#problem button')]);
    await window.shown();
    assert.equal(await window.problem(), '');
    await eventually('a picture', async () => await window.colours(VIEWS) > 200);
    assert.equal((await window.settings()).toString(), state);
    await window.page.browserContext().close();
});

test('the mode for an audience is in the address', () => inWindow('#present&beta=0.9', async window => {
    await eventually('a picture', async () => await window.colours({ x: 50, y: 100, width: 1180, height: 500 }) > 200);
    await window.press('Escape');
    await eventually('the mode has ended', async () => !(await window.settings()).has('present'));
}));

test('after the first visit no network is needed', () => inWindow('#scene=globe', async window => {
    await window.page.evaluate(() => navigator.serviceWorker.ready);
    await eventually('the files are kept', () => window.page.evaluate(async () => {
        const registration = await navigator.serviceWorker.getRegistration();
        return registration.active?.state === 'activated';
    }));
    const { address } = server;
    server.close();
    try {
        await window.page.reload();
        await window.shown();
        await eventually('a picture', async () => await window.colours(VIEWS) > 200);
    } finally {
        server = await serve();
    }
    assert.notEqual(address, server.address);
}));

test("other pages' caches stay, and nothing outside of the page's own server is asked", async () => {
    const site = await serve();
    const window = await Window.open(browser, server.address, '#scene=globe');
    const others = ['another page', 'gamow /elsewhere/ 1'];
    // They are there before the page comes for the first time.
    await window.page.goto(`${site.address}icon.png`);
    await window.page.evaluate(names => Promise.all(names.map(name => caches.open(name))), [...others, 'gamow / outdated']);
    await window.page.goto(`${site.address}#scene=globe`);
    await window.shown();
    const kept = await eventually('the page is kept', () => window.page.evaluate(async () => {
        const registration = await navigator.serviceWorker.getRegistration();
        const names = await caches.keys();
        return registration?.active?.state === 'activated' && !names.includes('gamow / outdated') && names;
    }), 60_000);
    assert.deepEqual(kept.filter(name => others.includes(name)), others);
    const own = kept.filter(name => name.startsWith('gamow / '));
    assert.equal(own.length, 1);
    assert.equal(site.sent['/gamow-web.wasm.lzma'], 1, 'what the page had is kept, and not sent again');
    const licences = await window.page.evaluate(async name => {
        const response = await (await caches.open(name)).match('./LICENSES-THIRD-PARTY.txt');
        return (await response.text()).length;
    }, own[0]);
    assert.ok(licences > 1000, `${licences}`);
    const refused = await window.page.evaluate(() => new Promise(done => {
        addEventListener('securitypolicyviolation', ({ effectiveDirective }) => done(effectiveDirective));
        fetch('http://localhost:9/').then(() => done('nothing'), () => {});
    }));
    assert.equal(refused, 'connect-src');
    // The refusal is in the console, and that icon.png has no icon of its own.
    window.problems.length = 0;
    await window.close();
    site.close();
});

test('by WebGL the rays draw what the packets draw', async () => {
    const pictures = [];
    for (const renderer of ['packets', 'rays']) {
        const window = await Window.open(browser, server.address, `#scene=street&beta=0.6&refine=off&renderer=${renderer}`);
        await eventually('a picture', async () => await window.colours(VIEWS) > 200);
        await window.rest(3000);
        pictures.push(await window.page.screenshot({ type: 'png', encoding: 'base64', clip: { x: 20, y: 90, width: 420, height: 190 } }));
        assert.equal(await window.problem(), '');
        if (pictures.length === 2) {
            const levels = await window.difference(pictures);
            assert.ok(levels > 0 && levels < 2, `${levels} levels of 255`);
        }
        await window.close();
    }
});

test('a screen of two pixels a point is drawn sharply', async () => {
    const sharp = await launch({ scale: 2 });
    try {
        const window = await Window.open(sharp, server.address, '#scene=globe&beta=0.9');
        const width = await window.page.evaluate(() => document.getElementById('gamow').width);
        assert.equal(width, 2 * await window.page.evaluate(() => innerWidth));
        await eventually('a picture', async () => await window.colours(VIEWS) > 200);
        await window.close();
    } finally {
        await sharp.close();
    }
});

// What draws the window, once it is shown; a canvas has one kind of graphics for good, and none while the
// page is loaded again.
const graphicsOf = ({ page }) => page.evaluate(() => {
    const canvas = document.getElementById('gamow');
    return document.getElementById('loading').hidden && ['webgpu', 'webgl2'].find(kind => canvas.getContext(kind));
}).catch(() => undefined);

// Has `use` use a browser with WebGPU on a screen.
async function withWebGPU(use) {
    const screen = await openScreen();
    let modern;
    try {
        modern = await launch({ graphics: WEBGPU, screen });
        await use(modern);
    } finally {
        await modern?.close();
        screen.close();
    }
}
const skip = !hasScreens() && 'no Xvfb';

test('the window is drawn by WebGPU as well', { skip }, () => withWebGPU(async modern => {
    const window = await Window.open(modern, server.address, '#scene=globe&beta=0.9');
    await eventually('a picture', async () => await window.colours(VIEWS) > 200);
    assert.equal(await graphicsOf(window), 'webgpu');
    await window.press('ArrowUp');
    await eventually('another speed', async () => Number((await window.settings()).get('beta')) > 0.9);
    assert.equal(await window.problem(), '');
    await window.close();
}));

test('WebGL takes the place of a WebGPU that fails, with the same state', { skip }, () => withWebGPU(async modern => {
    const ways = {
        'no device is given': () => {
            GPUAdapter.prototype.requestDevice = () => Promise.reject(new Error('none'));
        },
        'the device is lost before it is used': () => {
            const { requestDevice } = GPUAdapter.prototype;
            GPUAdapter.prototype.requestDevice = async function (...asked) {
                const device = await requestDevice.apply(this, asked);
                device.destroy();
                return device;
            };
        },
        'the device is lost later': () => {
            const { requestDevice } = GPUAdapter.prototype;
            GPUAdapter.prototype.requestDevice = async function (...asked) {
                return globalThis.device = await requestDevice.apply(this, asked);
            };
        },
    };
    for (const [way, before] of Object.entries(ways)) {
        const window = await Window.open(modern, server.address, '#scene=globe&beta=0.9', before);
        const isLater = way === 'the device is lost later';
        if (isLater) {
            assert.equal(await graphicsOf(window), 'webgpu');
            await window.press('ArrowUp');
            // Not in the address yet.
            await window.page.evaluate(() => device.destroy());
        }
        await eventually(`WebGL where ${way}`, async () => await graphicsOf(window) === 'webgl2');
        await eventually('a picture', async () => await window.colours(VIEWS) > 200);
        const settings = await window.settings();
        assert.equal(settings.get('scene'), 'globe', way);
        assert.equal(Number(settings.get('beta')) > 0.9, isLater, way);
        assert.equal(await window.problem(), '', way);
        await window.page.browserContext().close();
    }
}));

test('where WebGPU and WebGL fail a sentence says so, once', { skip }, () => withWebGPU(async modern => {
    const page = await modern.newPage();
    let loads = 0;
    page.on('load', () => { loads += 1; });
    await page.evaluateOnNewDocument(() => {
        GPUAdapter.prototype.requestDevice = () => Promise.reject(new Error('none'));
        const { getContext } = HTMLCanvasElement.prototype;
        HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
            return kind === 'webgl2' ? null : getContext.call(this, kind, ...more);
        };
    });
    await page.goto(server.address);
    await eventually('a sentence', () => page.evaluate(() => !document.getElementById('problem').hidden).catch(() => false));
    assert.equal(loads, 2);
    assert.match(await page.evaluate(() => document.getElementById('problem').textContent), /WebGPU nor WebGL 2/);
}));

test('a picture comes where a browser loses its WebGPU device by itself', async () => {
    const headless = await launch({ graphics: WEBGPU });
    try {
        const window = await Window.open(headless, server.address, '#scene=globe&beta=0.9');
        await eventually('a picture', async () => await window.colours(VIEWS) > 200);
        assert.equal(await window.problem(), '');
        await window.page.browserContext().close();
    } finally {
        await headless.close();
    }
});

test('without graphics a sentence says so', async () => {
    const blind = await launch({ graphics: NOTHING });
    try {
        const page = await blind.newPage();
        await page.goto(server.address);
        await page.waitForFunction(() => !document.getElementById('problem').hidden, { timeout: 60_000 });
        assert.match(await page.evaluate(() => document.getElementById('problem').textContent), /WebGPU nor WebGL 2/);
    } finally {
        await blind.close();
    }
});
