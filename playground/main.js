/** Shows the view that the address names: #play, #inspect or #compare. Each loads only what it needs. */
import { button, h } from "./shared/dom.js";
import { texts } from "./texts.js";

const VIEWS = {
	play: () => import("./play/view.js"),
	inspect: () => import("./inspect/view.js"),
	compare: () => import("./compare/view.js"),
};

const links = new Map(Object.keys(VIEWS).map((name) => [name, h("a", { href: `#${name}` }, texts.views[name])]));
document.getElementById("views").append(...links.values());
const note = h("p.note", { role: "status" });
document.querySelector("header").append(note);

let main = document.getElementById("view");
let shown = null;

/** The view and its argument in the address: #play/abc. */
function address() {
	const [name, argument = ""] = location.hash.slice(1).split("/");
	return { name: name in VIEWS ? name : "play", argument };
}

async function show() {
	const { name, argument } = address();
	if (shown?.name === name) {
		shown.view.open?.(argument);
		main.dataset.ready = name;
		return;
	}
	for (const [each, link] of links) {
		if (each === name) link.setAttribute("aria-current", "page");
		else link.removeAttribute("aria-current");
	}
	note.textContent = "";
	document.title = texts.title(texts.views[name]);
	shown?.view.close();
	shown = null;
	// a place of its own: one that comes late writes where nothing is seen any more
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
		place.replaceChildren(h("div.notice", { role: "alert" }, h("p", {}, texts.failed(error.message)), button(texts.again, () => location.reload())));
	}
}

/** Listens for what files do that are dragged over the page, in whose place the browser would show them. */
function onFile(type, listener) {
	addEventListener(type, (event) => {
		if (!event.dataTransfer.types.includes("Files")) return;
		event.preventDefault();
		listener(event);
	});
}

onFile("dragover", () => main.classList.toggle("dropping", Boolean(shown?.view.openFile)));
onFile("dragleave", ({ relatedTarget }) => main.classList.toggle("dropping", relatedTarget !== null));
onFile("drop", ({ dataTransfer: { files: [file] } }) => {
	main.classList.remove("dropping");
	if (shown?.view.openFile) shown.view.openFile(file);
	else note.textContent = texts.dropElsewhere(file.name);
});

addEventListener("hashchange", () => {
	delete main.dataset.ready;
	show().then(() => main.focus({ preventScroll: true }));
});
show();
