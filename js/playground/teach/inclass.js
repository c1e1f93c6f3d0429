/** How a class gets the page: from a web server, from a stick, by links and QR codes. */
import qrcode from "qrcode-generator";
import { copying } from "../shared/copying.js";
import { button, choice, field, h } from "../shared/dom.js";
import { texts } from "../shared/language.js";

const words = texts.inClass;
const SPACE = "http://www.w3.org/2000/svg";
/** The light modules around a code. Readers need four of them. */
const QUIET = 4;
const LOOPBACK = /^(localhost|127\.|\[::1\])/;
/** What a class opens: arguments of Play, with their names. */
const PLACES = [["all", texts.gallery.title], ...Object.entries(texts.lessons.list).map(([name, { title }], i) => [`lesson-${name}`, texts.teach.numbered(i + 1, title)]), ...Object.entries(texts.play.games)];

/** A QR code as a picture: dark on light in every scheme. */
function pictureOf(text) {
	const code = qrcode(0, "M");
	code.addData(text);
	code.make();
	const count = code.getModuleCount();
	const rows = Array.from({ length: count }, (_, row) => Array.from({ length: count }, (__, column) => (code.isDark(row, column) ? `M${column} ${row}h1v1h-1z` : "")).join("")).join("");
	const make = (tag, attributes) => {
		const element = document.createElementNS(SPACE, tag);
		for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
		return element;
	};
	const size = count + 2 * QUIET;
	const picture = make("svg", { viewBox: `${-QUIET} ${-QUIET} ${size} ${size}`, class: "qr", role: "img", "aria-label": words.qr, "shape-rendering": "crispEdges" });
	picture.append(make("path", { d: `M${-QUIET} ${-QUIET}h${size}v${size}h${-size}z`, fill: "#fff" }), make("path", { d: rows, fill: "#000" }));
	return picture;
}

const listed = (lines) => h("ol.steps", {}, ...lines.map((line) => h("li", {}, line)));
const command = (text) => h("pre", { tabindex: "0", "aria-label": words.line }, h("code", {}, text));

/** Shows the page. */
export function showInClass(main) {
	const isServed = location.protocol !== "file:";
	const here = isServed ? new URL(location.pathname, location.href).href : "";
	const address = h("input", { type: "url", value: here, oninput: () => show() });
	let place = "all";
	const link = h("a.address");
	const warning = h("p.busy", { role: "status" });
	const code = h("div.code-here");
	const places = choice(PLACES, place, (name) => {
		place = name;
		show();
	});
	const show = () => {
		const typed = URL.parse ? URL.parse(address.value.trim()) : URL.canParse(address.value.trim()) ? new URL(address.value.trim()) : null;
		const isGood = typed !== null && /^https?:$/.test(typed.protocol);
		warning.textContent = !isGood ? words.noAddress : LOOPBACK.test(typed.host) ? words.onlyHere : "";
		warning.hidden = warning.textContent === "";
		code.replaceChildren();
		link.textContent = "";
		if (!isGood) return link.removeAttribute("href");
		typed.hash = `play/${place}`;
		link.href = link.textContent = typed.href;
		// no phone opens an address of this computer alone
		return warning.hidden && code.append(pictureOf(typed.href));
	};
	main.replaceChildren(h("section.sheet", { "aria-label": words.title },
		h("div.tools.no-print", {}, h("a", { href: "#teach" }, texts.teach.all), button(texts.teach.print, () => print())),
		h("h2", {}, words.title), h("p.no-print", {}, words.intro),
		h("h3", {}, words.links), h("p.no-print", {}, words.linksNote),
		h("div.tools.no-print", {}, field(words.address, address), field(words.place, places)),
		warning, code, h("p", {}, link), h("div.tools.no-print", {}, ...copying(link)),
		h("section.no-print", {},
			h("h3", {}, words.server), h("p", {}, words.serverNote), command("python3 -m http.server 8080"), command("npx http-server -p 8080"), listed(words.serverSteps),
			h("p", {}, words.antw), command("./antw playground -Dhost=0.0.0.0"),
			h("h3", {}, words.stick), listed(words.stickSteps),
			isServed ? h("p", {}, h("a", { href: "starlogo-nova.html", download: "starlogo-nova.html" }, words.file)) : null)));
	show();
	main.dataset.drawn = "in-class";
}
