/** Reads XML as trees of plain objects. */
import { SaxesParser } from "saxes";

/**
 * The root element of a document: { name, attributes, children, texts, parent, place }, the names without prefixes, texts its own pieces
 * of text and CDATA, place its number among its parent's children; null if there is none.
 *
 * @throws TypeError if it is not well-formed
 */
export function parseXml(source) {
	const parser = new SaxesParser({ xmlns: false, position: true });
	let root = null;
	let open = null;
	parser.on("error", (error) => {
		throw new TypeError(error.message);
	});
	parser.on("opentag", (tag) => {
		const attributes = Object.create(null);
		for (const [name, value] of Object.entries(tag.attributes)) attributes[localName(name)] ??= value;
		const element = { name: localName(tag.name), attributes, children: [], texts: [], parent: open };
		open?.children.push(element);
		root ??= element;
		open = element;
	});
	parser.on("closetag", () => {
		open = open.parent;
	});
	const addText = (text) => open?.texts.push(text);
	parser.on("text", addText);
	parser.on("cdata", addText);
	parser.write(source).close();
	return root;
}

function localName(name) {
	return name.slice(name.indexOf(":") + 1);
}
