/**
 * Loads the page's words in one language, and shows the view in the address: #play, #inspect, #compare, #measure, #level or #teach. Each view
 * loads only the files that it needs.
 */
import { setColourProperties } from "./shared/drawing/colours.js";
import { button, choice, h } from "./shared/dom.js";
import { mainFileOf } from "./shared/files/files.js";
import { addWords, failure, furtherWords, loadWords, texts } from "./shared/language.js";
import { recall, remember } from "./shared/files/memory.js";
import { DOCS } from "./shared/files/served.js";

/** The languages, each with its own name, the words that every view needs, and further parts of its words. */
const LANGUAGES = {
	en: {
		name: "English", load: () => import("./languages/en.js"),
		further: { class: () => import("./languages/class/en.js"), game: () => import("./languages/game/en.js"), lab: () => import("./languages/lab/en.js") },
	},
	de: {
		name: "Deutsch", load: () => import("./languages/de.js"),
		further: { class: () => import("./languages/class/de.js"), game: () => import("./languages/game/de.js"), lab: () => import("./languages/lab/de.js") },
	},
};
const LANGUAGE_KEY = "starlogo-playground.language";

const VIEWS = {
	play: () => import("./play/view.js"),
	inspect: () => loadWords("lab").then(() => import("./inspect/view.js")),
	compare: () => loadWords("lab").then(() => import("./compare/view.js")),
	measure: () => loadWords("lab").then(() => import("./measure/view.js")),
	level: () => loadWords("lab").then(() => import("./level/view.js")),
	teach: () => Promise.all([loadWords("class"), loadWords("game")]).then(() => import("./teach/view.js")),
};

const links = new Map(Object.keys(VIEWS).map((name) => [name, h("a", { href: `#${name}` })]));
const note = h("p.note", { role: "status" });
/** The milliseconds for which the note is shown. */
const NOTE_MS = 8000;
let noteTimer = 0;

/** Shows a note over the page's head, so that nothing moves; "" removes it. */
function say(text) {
	clearTimeout(noteTimer);
	note.textContent = text;
	if (text) noteTimer = setTimeout(() => say(""), NOTE_MS);
}

/**
 * The language in the address (?language=de). Otherwise the language chosen here before, or the first of the browser's languages that the
 * page has.
 */
function languageOf() {
	const asked = [new URLSearchParams(location.search).get("language"), recall(LANGUAGE_KEY), ...navigator.languages.map((each) => each.split("-")[0])];
	return asked.find((each) => Object.hasOwn(LANGUAGES, each)) ?? "en";
}

/** Reloads the page in a language. If the browser stores nothing, the address contains the language. */
function changeLanguage(code) {
	const address = new URL(location.href);
	address.searchParams.delete("language");
	if (!remember(LANGUAGE_KEY, code)) address.searchParams.set("language", code);
	if (address.href === location.href) location.reload();
	else location.replace(address);
}

/** Builds the page's frame in its language. */
async function begin() {
	setColourProperties(document.documentElement);
	const code = languageOf();
	addWords((await LANGUAGES[code].load()).texts);
	for (const [name, load] of Object.entries(LANGUAGES[code].further)) furtherWords[name] = { load };
	document.documentElement.lang = code;
	document.querySelector("h1 span").textContent = texts.page.name;
	const views = document.getElementById("views");
	views.setAttribute("aria-label", texts.page.views);
	for (const [name, link] of links) link.textContent = texts.views[name];
	views.append(...links.values());
	if (DOCS) views.after(h("nav.helps", { "aria-label": texts.page.help }, ...[["guide", "index.html"], ["api", "api/index.html"]].map(([name, page]) => h("a", { href: DOCS + page, target: "_blank", hreflang: "en" }, texts.page[name]))));
	const languages = choice(Object.entries(LANGUAGES).map(([each, { name }]) => [each, name]), code, changeLanguage);
	languages.setAttribute("aria-label", texts.page.language);
	languages.className = "language";
	// a link would change the address, which names the view
	document.body.prepend(button(texts.page.skip, () => main.focus(), { class: "skip" }));
	document.querySelector("header").append(note, languages);
	await show();
}

let main = document.getElementById("view");
let shown = null;

/** The view in the address and its argument: #play/abc. Play says if there is no such view. */
function address() {
	const hash = location.hash.slice(1);
	const [name, argument = ""] = hash.split("/");
	return Object.hasOwn(VIEWS, name) ? { name, argument } : { name: "play", argument: hash };
}

async function show() {
	const { name, argument } = address();
	if (shown?.name === name) {
		await shown.view.open?.(argument);
		main.dataset.ready = name;
		return;
	}
	for (const [each, link] of links) {
		if (each === name) link.setAttribute("aria-current", "page");
		else link.removeAttribute("aria-current");
	}
	say("");
	document.title = texts.title(texts.views[name]);
	shown?.view.close();
	shown = null;
	// Each view has its own element. A view that finishes loading too late writes into one that is no longer shown.
	const place = h("main", { id: "view", tabindex: "-1", class: name }, h("p.waiting", { role: "status" }, texts.loading));
	main.replaceWith(place);
	main = place;
	try {
		const { createView } = await VIEWS[name]();
		const view = place.isConnected ? await createView(place, argument) : null;
		if (!place.isConnected) {
			view?.close();
			return;
		}
		shown = { name, view };
		// for the browser's console, and for tests
		globalThis.playground = view;
		place.dataset.ready = name;
	} catch (error) {
		place.replaceChildren(h("div.notice", { role: "alert" }, h("p", {}, failure(error)), button(texts.again, () => location.reload())));
	}
}

/** Listens to files that are dragged over the page. Otherwise the browser would show them instead of the page. */
function onFile(type, listener) {
	addEventListener(type, (event) => {
		if (!event.dataTransfer.types.includes("Files")) return;
		event.preventDefault();
		listener(event);
	});
}

onFile("dragover", () => main.classList.toggle("dropping", Boolean(shown?.view.openFile)));
onFile("dragleave", ({ relatedTarget }) => main.classList.toggle("dropping", relatedTarget !== null));
onFile("drop", ({ dataTransfer }) => {
	main.classList.remove("dropping");
	const files = [...dataTransfer.files];
	const file = mainFileOf(files);
	if (shown?.view.openFile && shown.view.takes?.(file) !== false) shown.view.openFile(file, files);
	else say(/\.json$/i.test(file.name) ? texts.dropProgram(file.name) : texts.dropElsewhere(file.name));
});

// who misses a field would mark the whole page
addEventListener("keydown", (event) => {
	const isAll = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "a";
	if (isAll && !event.target.closest("input, textarea, pre, dialog, .sheet") && !main.classList.contains("teach")) event.preventDefault();
});

addEventListener("hashchange", () => {
	// a dialog is about the view that it was opened in
	for (const dialog of document.querySelectorAll("dialog[open]")) dialog.close();
	delete main.dataset.ready;
	show().then(() => main.focus({ preventScroll: true }));
});
begin();
