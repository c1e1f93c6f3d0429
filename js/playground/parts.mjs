/**
 * Divides the engine into parts, so that each view loads only what it needs. A bundler leaves out unused classes, but it keeps together what is in
 * one file.
 */
import { readFileSync, readdirSync } from "node:fs";
import path from "node:path";

const NAME = "starlogo-collision";
const IMPORT = new RegExp(`^import \\{([^}]*)\\} from "${NAME}";`, "gm");
const DECLARATION = /^(?:const|let|class|(?:async )?function\*?) ([\w$]+)/gm;
const COMMENT_OR_STRING = /\/\*[^]*?\*\/|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'/g;
// not a member's name
const WORD = /(?<![\w$.]|(?<!\.\.)\.)[A-Za-z_$][\w$]*/g;
/** Stands for a name that a part uses and does not import. */
const LOST = "$lost";

/** The scripts in some folders. */
const scriptsIn = (folders) => folders.flatMap((folder) => readdirSync(folder, { recursive: true }).filter((file) => file.endsWith(".js") && !file.includes("node_modules")).map((file) => path.join(folder, file)));

const split = (names) => names.split(",").map((name) => name.trim()).filter((name) => name !== "");

/**
 * Returns a plugin of esbuild, the definitions that it needs, and a check of the files that were written.
 *
 * @param {string} file the engine as a text in which each declaration begins a line
 * @param {string[]} folders the scripts in these import the engine
 * @param {(script: string) => string|null} loadedWith what a script is loaded with: the same name for scripts that are loaded together, "" for
 *     every view, null if the page does not use the script
 */
export function engineInParts(file, folders, loadedWith) {
	const engine = new Engine(readFileSync(file, "utf8"));
	const scripts = new Set(scriptsIn(folders));
	for (const script of scripts) {
		const user = loadedWith(script);
		const imported = [...readFileSync(script, "utf8").matchAll(IMPORT)].flatMap(([, names]) => split(names));
		if (user !== null) for (const name of imported) engine.note(name, user);
	}
	engine.divide();
	const plugin = {
		name: "engine-in-parts",
		setup({ onLoad, onResolve }) {
			onResolve({ filter: new RegExp(`^${NAME}/part`) }, ({ path: part }) => ({ path: part, namespace: NAME, sideEffects: false }));
			onLoad({ filter: /.*/, namespace: NAME }, ({ path: part }) => ({ contents: engine.textOf(part), loader: "js" }));
			onLoad({ filter: /\.js$/ }, ({ path: script, with: { type } }) => {
				if (type === "text" || !scripts.has(script)) return null;
				return { contents: readFileSync(script, "utf8").replace(IMPORT, (_, names) => engine.importsOf(split(names))), loader: "js" };
			});
		},
	};
	// a name that is declared nowhere is replaced
	const define = Object.fromEntries(engine.names.filter((name) => !(name in globalThis)).map((name) => [name, LOST]));
	const check = (written) => {
		if (written.some((each) => readFileSync(each, "utf8").includes(LOST))) throw new Error("a part of the engine uses a name that it does not import");
	};
	return { plugin, define, check };
}

class Engine {
	/** The names of the declarations in their order, their indices, their texts, and the indices of those that each uses. */
	names;
	#indices;
	#texts;
	#uses;
	/** By index: the declarations that must be in the same part; who uses it; its part's name. */
	#together;
	#users;
	#parts;
	/** The declared names of exported ones. */
	#exports;

	constructor(text) {
		const end = text.lastIndexOf("\nexport {");
		const found = [...text.slice(0, end).matchAll(DECLARATION)];
		this.names = found.map(([, name]) => name);
		this.#indices = new Map(this.names.map((name, i) => [name, i]));
		this.#texts = found.map(({ index }, i) => text.slice(index, found[i + 1]?.index ?? end));
		this.#uses = this.#texts.map((each) => [...new Set(each.replace(COMMENT_OR_STRING, '""').match(WORD))].map((word) => this.#indices.get(word)).filter((index) => index !== undefined));
		this.#together = this.#withVariables();
		this.#users = this.#texts.map(() => new Set());
		this.#exports = new Map(split(text.slice(end).replace(/^\nexport \{|\};\s*$/g, "")).map((each) => each.split(" as ")).map(([declared, name]) => [name ?? declared, declared]));
	}

	/** A module cannot write a variable of another one, so a variable and all that writes it belong together. */
	#withVariables() {
		const together = this.#texts.map((_, i) => [i]);
		this.#texts.forEach((text, variable) => {
			if (!text.startsWith("let ")) return;
			const name = this.names[variable].replaceAll("$", "\\$");
			const written = new RegExp(`(?<![\\w$.])${name} *(?:[^\\w\\s=!<>;,.)(]{0,3}=(?![=>])|\\+\\+|--)|(?:\\+\\+|--)${name}(?![\\w$])`);
			const writers = [...this.#texts.keys()].filter((i) => this.#uses[i].includes(variable) && written.test(this.#texts[i]));
			const all = [...new Set([variable, ...writers].flatMap((i) => together[i]))];
			for (const each of all) together[each] = all;
		});
		return together;
	}

	#indexOf(name) {
		if (!this.#exports.has(name)) throw new Error(`the engine exports no ${name}`);
		return this.#indices.get(this.#exports.get(name));
	}

	/** Notes who uses an exported name, and so all that it uses itself. */
	note(name, user) {
		const open = [this.#indexOf(name)];
		while (open.length > 0) {
			for (const each of this.#together[open.pop()]) {
				if (this.#users[each].has(user)) continue;
				this.#users[each].add(user);
				open.push(...this.#uses[each]);
			}
		}
	}

	/**
	 * Puts what has the same users into one part. What a part uses has no fewer users, so no two parts use each other. A few parts are smaller than many,
	 * so what Play and Compare use is one part for all views with games, and what files of the user share with a view is loaded always.
	 */
	divide() {
		this.#parts = this.#users.map((users) => {
			if (users.size === 0) return null;
			if (users.has("") || users.has("files") && users.size > 1) return "/part";
			return users.has("play") && users.has("compare") ? "/part of games" : `/part of ${[...users].sort().join(", ")}`;
		});
	}

	#import(index, name = this.names[index]) {
		return `import { ${this.names[index]} as ${name} } from "${NAME}${this.#parts[index]}";`;
	}

	/** The import statements for exported names. */
	importsOf(names) {
		return names.map((name) => this.#import(this.#indexOf(name), name)).join(" ");
	}

	/** The text of a part. */
	textOf(part) {
		const own = [...this.#texts.keys()].filter((index) => NAME + this.#parts[index] === part);
		const others = [...new Set(own.flatMap((index) => this.#uses[index]))].filter((index) => NAME + this.#parts[index] !== part);
		return [...others.map((index) => this.#import(index)), ...own.map((index) => this.#texts[index]), `export { ${own.map((index) => this.names[index]).join(", ")} };`].join("\n");
	}
}
