//! The page: its canvas, its address, and its words for when the program cannot go on.

use std::cell::RefCell;
use std::collections::BTreeMap;

use js_sys::{Reflect, Uint8Array};
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{Element, Event, History, HtmlCanvasElement, Response, ShareData, Storage, Window};

use super::tasks;

/// Name under which a tab keeps why WebGPU has failed in it.
const WEBGPU_FAILURE: &str = "gamow/webgpu-failure";

/// The canvas of the page that the window is drawn on.
#[must_use]
pub fn canvas() -> Option<HtmlCanvasElement> {
    let canvas = window()?.document()?.get_element_by_id("gamow")?;
    canvas.dyn_into().ok()
}

/// Returns the address of the page without the fragment.
#[must_use]
pub fn address() -> String {
    let href = window().and_then(|window| window.location().href().ok()).unwrap_or_default();
    href.split('#').next().unwrap_or_default().to_owned()
}

/// Returns the address of the repository that the page belongs to, if the page knows it.
#[must_use]
pub fn source() -> Option<String> {
    root()?.get_attribute("data-source")
}

/// Returns the fragment of the address, behind its `#`.
#[must_use]
pub fn fragment() -> String {
    let hash = window().and_then(|window| window.location().hash().ok()).unwrap_or_default();
    hash.trim_start_matches('#').to_owned()
}

/// Replaces the fragment of the address, without a new entry in the browser's history.
pub fn replace_fragment(fragment: &str) {
    if let Some(history) = history() {
        // A browser may refuse it when it comes too often: then the next one counts.
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&with_fragment(fragment)));
    }
}

/// Gives the address this fragment in a new entry of the browser's history, so that Back leads to the one
/// before.
pub fn push_fragment(fragment: &str) {
    if let Some(history) = history() {
        let _ = history.push_state_with_url(&JsValue::NULL, "", Some(&with_fragment(fragment)));
    }
}

fn history() -> Option<History> {
    window()?.history().ok()
}

fn with_fragment(fragment: &str) -> String {
    format!("{}#{fragment}", address())
}

/// Tells the page that the window is shown, in place of its words.
pub fn show_window() {
    tell("gamow-shown");
}

/// Returns whether anything is drawn on the canvas. Callers ask in the task that drew the frame: the browser
/// clears the canvas of WebGL after it.
#[must_use]
pub fn has_picture() -> bool {
    tell("gamow-painted");
    root().is_some_and(|root| root.get_attribute("data-painted").as_deref() == Some("true"))
}

/// Whether the browser has WebGPU.
#[must_use]
pub fn offers_webgpu() -> bool {
    window().is_some_and(|window| js_sys::Reflect::has(&window.navigator(), &"gpu".into()).unwrap_or(false))
}

/// Whether the browser has taken WebGL's graphics away in this tab: `web/page.js` keeps that.
#[must_use]
pub fn graphics_were_lost() -> bool {
    tab_storage().is_some_and(|storage| matches!(storage.get_item("gamow/graphics-lost"), Ok(Some(_))))
}

/// Returns why WebGPU has failed in this tab, if it has.
#[must_use]
pub fn webgpu_failure() -> Option<String> {
    tab_storage()?.get_item(WEBGPU_FAILURE).ok()?
}

/// Loads the page again in a tab where WebGPU has failed for this `reason`. Returns false, and does nothing,
/// where that is known already or cannot be kept: the page would be loaded again for ever.
#[must_use]
pub fn reload_without_webgpu(reason: &str) -> bool {
    let is_new = webgpu_failure().is_none();
    let is_kept = || tab_storage().is_some_and(|storage| storage.set_item(WEBGPU_FAILURE, reason).is_ok());
    is_new && is_kept() && window().is_some_and(|window| window.location().reload().is_ok())
}

/// Copies `text` to the clipboard; returns whether the browser confirms it.
pub async fn copy_text(text: &str) -> bool {
    // Elsewhere there is no clipboard at all.
    let Some(window) = window().filter(Window::is_secure_context) else { return false };
    JsFuture::from(window.navigator().clipboard().write_text(text)).await.is_ok()
}

thread_local!(static FETCHED: RefCell<BTreeMap<&'static str, Option<&'static [u8]>>> = const { RefCell::new(BTreeMap::new()) });

/// Returns the bytes of the file at this `place` below the page's folder; `None` while they come, and for
/// ever if they cannot. The first call for a place fetches them, and has `then` called once they are there.
pub fn fetched(place: &'static str, then: impl FnOnce() + 'static) -> Option<&'static [u8]> {
    if let Some(bytes) = FETCHED.with_borrow(|fetched| fetched.get(place).copied()) {
        return bytes;
    }
    FETCHED.with_borrow_mut(|fetched| fetched.insert(place, None));
    tasks::spawn(async move {
        let Some(bytes) = fetch(place).await else { return };
        // They are asked for as long as the page is there.
        FETCHED.with_borrow_mut(|fetched| fetched.insert(place, Some(bytes.leak())));
        then();
    });
    None
}

async fn fetch(place: &str) -> Option<Vec<u8>> {
    let response: Response = JsFuture::from(window()?.fetch_with_str(place)).await.ok()?.dyn_into().ok()?;
    let bytes = response.ok().then(|| response.array_buffer().ok())??;
    Some(Uint8Array::new(&JsFuture::from(bytes).await.ok()?).to_vec())
}

/// Whether links are handed to the system's sheet for sharing: where it has one, and a finger to use it.
#[must_use]
pub fn shares_links() -> bool {
    let has_sheet = window().is_some_and(|window| {
        Reflect::has(&window.navigator(), &JsValue::from_str("share")).unwrap_or_default()
    });
    has_sheet && has_coarse_pointer()
}

/// Hands `link` to the system's sheet for sharing; returns whether it was shown, also if it was left then.
pub async fn share(link: &str) -> bool {
    let Some(window) = window() else { return false };
    let data = ShareData::new();
    data.set_url(link);
    match JsFuture::from(window.navigator().share_with_data(&data)).await {
        Ok(_) => true,
        Err(error) => error.dyn_ref::<js_sys::Error>().is_some_and(|error| error.name() == "AbortError"),
    }
}

/// Has the page show `text` over the window, selected, for the user to copy.
pub fn offer_text(text: &str) {
    if let Some(root) = root() {
        let _ = root.set_attribute("data-text", text);
    }
    tell("gamow-text");
}

/// Has the page show a sentence and a button to load it again, in place of the window.
pub fn show_problem(problem: &str) {
    if let Some(root) = root() {
        let _ = root.set_attribute("data-problem", problem);
    }
    tell("gamow-problem");
}

/// Has the page say that the program has stopped by a defect of its own, in place of the window.
pub fn show_defect() {
    show_problem(
        "The program has stopped: this is a defect. What was shown is in the address, and the answers in lessons are kept. The \
        browser's console has the details.",
    );
}

/// Tells the page whether the window is the screen of a stereoscope: it then asks for the whole screen, and
/// for how the device is turned.
pub fn set_stereoscope(is_on: bool) {
    if let Some(root) = root() {
        let _ = root.set_attribute("data-stereoscope", if is_on { "on" } else { "off" });
    }
    tell("gamow-stereoscope");
}

/// Returns how the device is turned, as far as the page knows: alpha, beta, gamma and the turn of what is
/// shown, degrees.
#[must_use]
pub fn turned() -> Option<[f64; 4]> {
    numbers("data-turned")
}

/// Returns the longer and the shorter side of the screen, in points of the page: a screen that is turned
/// keeps its sides.
#[must_use]
pub fn screen_sides() -> Option<[f32; 2]> {
    let [width, height] = numbers::<2>("data-screen")?.map(|side| side as f32);
    (width >= 1.0 && height >= 1.0).then_some([width.max(height), width.min(height)])
}

/// Whether the system's user wants less motion.
#[must_use]
pub fn less_motion() -> bool {
    has_media("(prefers-reduced-motion: reduce)")
}

/// Whether the system's user wants more contrast.
#[must_use]
pub fn more_contrast() -> bool {
    has_media("(prefers-contrast: more)")
}

/// Whether the main way to point is coarse, such as a finger.
#[must_use]
pub fn has_coarse_pointer() -> bool {
    has_media("(pointer: coarse)")
}

/// Whether the browser's screen and system are as this media query asks.
fn has_media(query: &str) -> bool {
    let is_so = || {
        let window = window()?;
        let asked = Reflect::get(&window, &"matchMedia".into()).ok()?;
        let asked = asked.dyn_into::<js_sys::Function>().ok()?;
        let answer = asked.call1(&window, &query.into()).ok()?;
        Reflect::get(&answer, &"matches".into()).ok()?.as_bool()
    };
    is_so().unwrap_or(false)
}

/// Returns the numbers that the page keeps in this attribute, with a space between two.
fn numbers<const N: usize>(attribute: &str) -> Option<[f64; N]> {
    let text = root()?.get_attribute(attribute)?;
    let numbers: Vec<f64> = text.split(' ').map(str::parse).collect::<Result<_, _>>().ok()?;
    numbers.try_into().ok()
}

fn tab_storage() -> Option<Storage> {
    window()?.session_storage().ok()?
}

fn root() -> Option<Element> {
    window()?.document()?.document_element()
}

fn tell(event: &str) {
    if let (Some(window), Ok(event)) = (window(), Event::new(event)) {
        let _ = window.dispatch_event(&event);
    }
}

/// Calls `then` at each `event` of the browser's window, for as long as the page is there.
pub fn on(event: &str, then: impl FnMut() + 'static) {
    let closure = Closure::<dyn FnMut()>::new(then);
    if let Some(window) = window() {
        let _ = window.add_event_listener_with_callback(event, closure.as_ref().unchecked_ref());
    }
    // It lasts as long as the page.
    closure.forget();
}

fn window() -> Option<Window> {
    web_sys::window()
}
