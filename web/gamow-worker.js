// Another instance of the program, which works beside the page's own: it gets the compiled module, and then
// its jobs.
addEventListener('message', async ({ data }) => {
    try {
        const { default: start } = await import('./gamow-web.js');
        await start({ module_or_path: data });
    } catch (error) {
        postMessage([`a worker could not be started (${error.message ?? error})`]);
    }
}, { once: true });
