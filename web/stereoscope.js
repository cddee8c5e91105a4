// A phone as a stereoscope: what it needs of the browser beside the window. Each is asked for at a touch,
// where browsers demand one, and none of it must be granted.
const root = document.documentElement;
root.dataset.screen = `${screen.width} ${screen.height}`;
const tell = event => dispatchEvent(new Event(event));
const isOn = () => root.dataset.stereoscope === 'on';
// What is refused, or not known here, is done without.
const granted = async ask => {
    try {
        return await ask();
    } catch (error) {
        console.info(`stereoscope: ${error?.message ?? error}`);
    }
};
let isFull = false, isAsked = false, awake;

// Hands on how the device is turned: alpha, beta, gamma, and the turn of what is shown, degrees.
function turned({ alpha, beta, gamma }) {
    if (alpha === null || beta === null || gamma === null) return;
    root.dataset.turned = [alpha, beta, gamma, screen.orientation?.angle ?? globalThis.orientation ?? 0].join(' ');
    tell('gamow-turned');
}

// Anew where it is granted only later.
function listen() {
    removeEventListener('deviceorientation', turned);
    if (isOn()) addEventListener('deviceorientation', turned);
}

// Before anything is waited for: a touch counts for a moment only.
function touched() {
    if (!isOn() || isAsked) return;
    isAsked = true;
    const asked = globalThis.DeviceOrientationEvent?.requestPermission;
    if (asked) granted(() => DeviceOrientationEvent.requestPermission()).then(answer => answer === 'granted' && listen());
    granted(async () => {
        if (document.fullscreenElement || !root.requestFullscreen) return;
        await root.requestFullscreen({ navigationUI: 'hide' });
        isFull = true;
        await granted(() => screen.orientation?.lock?.('landscape'));
        if (!isOn()) await left();
    });
    granted(async () => { awake ??= await navigator.wakeLock?.request('screen'); });
}

async function left() {
    removeEventListener('deviceorientation', turned);
    isAsked = false;
    const [wasFull, lock] = [isFull, awake];
    isFull = false;
    awake = undefined;
    if (lock) await granted(() => lock.release());
    if (wasFull && document.fullscreenElement) await granted(() => document.exitFullscreen());
}

addEventListener('gamow-stereoscope', () => isOn() ? listen() : left());
// The window's canvas keeps its touches to itself.
for (const event of ['touchend', 'mouseup']) addEventListener(event, touched, { capture: true });
addEventListener('fullscreenchange', () => {
    if (isFull && !document.fullscreenElement && isOn()) tell('gamow-leave-stereoscope');
});
