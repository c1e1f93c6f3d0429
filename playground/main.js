/** Shows the view that the address names: #play, #inspect or #compare. Each loads only what it needs. */
import { h } from "./shared/dom.js";
import { texts } from "./texts.js";

const VIEWS = {
	play: () => import("./play/view.js"),
	inspect: () => import("./inspect/view.js"),
	compare: () => import("./compare/view.js"),
};

const main = document.getElementById("view");
const links = new Map(Object.keys(VIEWS).map((name) => [name, h("a", { href: `#${name}` }, texts.views[name])]));
document.getElementById("views").append(...links.values());

let shown = null;
let turn = 0;

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
	const mine = ++turn;
	for (const [each, link] of links) {
		if (each === name) link.setAttribute("aria-current", "page");
		else link.removeAttribute("aria-current");
	}
	shown?.view.close();
	shown = null;
	main.className = name;
	main.replaceChildren(h("p.waiting", { role: "status" }, texts.loading));
	try {
		const { createView } = await VIEWS[name]();
		if (mine !== turn) return;
		const view = await createView(main, argument);
		if (mine !== turn) view.close();
		else shown = { name, view };
		// for the browser's console, and for tests
		globalThis.playground = view;
		main.dataset.ready = name;
	} catch (error) {
		if (mine !== turn) return;
		main.replaceChildren(h("p.notice", { role: "alert" }, texts.failed(error.message)));
	}
}

addEventListener("hashchange", () => {
	delete main.dataset.ready;
	show().then(() => main.focus({ preventScroll: true }));
});
show();
