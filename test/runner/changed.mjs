#!/usr/bin/env node
/**
 * Finds which classes of the tests' translation are out of date: those whose sources changed, and if one looks different from outside,
 * all that use it, directly or by others.
 *
 * node test/runner/changed.mjs TRANSPILED OUT [--keep]
 *
 * TRANSPILED is a translation of all classes, with its sources noted. OUT gets a main class for the compiler, and changed.properties:
 *
 *   whole    if all classes have to be compiled. TRANSPILED is marked as not done then
 *   classes  otherwise, those to compile, if there are any
 *   engine   if these are the engine's alone, a folder with their sources: the compiler takes the others from a SWC, in a quarter of the
 *            time. The file outlines.json beside OUT changes when that SWC has to
 *
 * With --keep the classes in OUT have been compiled, and TRANSPILED gets them in place of its own, without those that are gone: the next
 * run finds only what changed since.
 */
import { copyFileSync, cpSync, existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { compiledFilesIn } from "../../js/module/assemble.mjs";
import { ROOT, compiledFile, compiledFolder } from "../../js/module/names.mjs";
import { writeRoots } from "../../js/module/roots.mjs";
import { gone, outdated, readSources } from "./outdated.mjs";
import { testRoots } from "./roots.mjs";

/** With more classes than these, compiling all takes about as long. */
const MOST = 200;

const [transpiled, out, keeps] = process.argv.slice(2);
const done = join(transpiled, "done");
const noted = join(transpiled, "roots/sources.json");
const found = join(out, "sources.json");

if (keeps) keep();
else {
	rmSync(out, { recursive: true, force: true });
	mkdirSync(out, { recursive: true });
	writeFileSync(join(out, "changed.properties"), properties());
}

function properties() {
	const isTranslated = (qname) => existsSync(compiledFile(transpiled, qname));
	const now = readSources();
	const isWhole = existsSync(done) && existsSync(noted);
	const classes = isWhole ? outdated(JSON.parse(readFileSync(noted, "utf8")), now, isTranslated, new Set(testRoots())) : null;
	if (classes === null || classes.length > MOST) {
		rmSync(done, { force: true });
		return "whole=true\n";
	}
	if (classes.length === 0) {
		note(now);
		return "";
	}
	writeRoots(join(out, "roots"), namesOfPackages(classes));
	writeFileSync(join(out, "classes.json"), JSON.stringify(classes));
	writeFileSync(found, JSON.stringify(now));
	console.log(`translated anew: ${classes.length <= 8 ? classes.join(", ") : `${classes.length} classes`}`);
	return `classes=${classes.join(",")}\n${classes.every((qname) => isOfEngine(now, qname)) ? `engine=${copySources(now, classes, isTranslated)}\n` : ""}`;
}

function isOfEngine(now, qname) {
	return /^src\/starlogo\/(?!away3d\/)/.test(now.files[qname].file);
}

/**
 * Copies the sources of some classes, of those that they may be the first to use, of those that have to be there before them, as their last
 * translations say, of those that only their packages see, and the texts that sources include. Notes what classes can see of the engine's.
 * Returns the copies' folder.
 */
function copySources(now, classes, isTranslated) {
	const names = Object.keys(now.files).filter((qname) => isOfEngine(now, qname)).sort();
	const isInternal = (qname) => /^ {4}internal /m.test(readFileSync(join(ROOT, now.files[qname].file), "utf8"));
	const copied = new Set([...classes, ...names.filter((qname) => !isTranslated(qname))]);
	for (const qname of copied) {
		const text = isTranslated(qname) ? readFileSync(compiledFile(transpiled, qname), "utf8") : "";
		const isNeeded = (name) => text.includes(`goog.require('${name}')`) || packageOf(name) === packageOf(qname) && isInternal(name);
		for (const name of names) if (isNeeded(name)) copied.add(name);
	}
	const taken = new Set([...[...copied].map((qname) => now.files[qname].file), ...Object.keys(now.included)].map((file) => join(ROOT, file)));
	const to = join(out, "src");
	cpSync(join(ROOT, "src/starlogo"), join(to, "starlogo"), { recursive: true, filter: (file) => taken.has(file) || statSync(file).isDirectory() });
	const seen = JSON.stringify(names.map((qname) => [qname, now.files[qname].outline]));
	const outlines = join(dirname(out), "outlines.json");
	if (!existsSync(outlines) || readFileSync(outlines, "utf8") !== seen) writeFileSync(outlines, seen);
	return to;
}

/** Copies the files of all classes that were compiled. */
function keep() {
	const missing = JSON.parse(readFileSync(join(out, "classes.json"), "utf8")).filter((qname) => !existsSync(compiledFile(out, qname)));
	if (missing.length > 0) throw new Error(`not compiled: ${missing.join(", ")}`);
	for (const file of compiledFilesIn(compiledFolder(out))) {
		const to = join(compiledFolder(transpiled), file);
		mkdirSync(dirname(to), { recursive: true });
		copyFileSync(join(compiledFolder(out), file), to);
	}
	note(JSON.parse(readFileSync(found, "utf8")));
}

/** Deletes the files of classes that are gone, then notes the sources: if this is ended before, it is done again. */
function note(now) {
	for (const qname of gone(JSON.parse(readFileSync(noted, "utf8")), now)) rmSync(compiledFile(transpiled, qname), { force: true });
	writeFileSync(noted, JSON.stringify(now));
}

/**
 * Writes a class into each package that names the classes to compile there, because some can be seen in their package alone. The
 * compiler tells the errors only of what the main class uses.
 *
 * @returns the classes that it writes
 */
function namesOfPackages(classes) {
	return [...new Set(classes.map(packageOf))].map((name) => {
		const own = classes.filter((qname) => packageOf(qname) === name).map((qname) => qname.split(".").pop());
		const className = `ChangedIn_${name.replaceAll(".", "_")}`;
		const folder = join(out, "roots", name.replaceAll(".", "/"));
		mkdirSync(folder, { recursive: true });
		writeFileSync(join(folder, `${className}.as`), `package ${name}
{
    public class ${className}
    {
        public static const ALL:Array = [${own.join(", ")}];
    }
}
`);
		return name === "" ? className : `${name}.${className}`;
	});
}

function packageOf(qname) {
	return qname.split(".").slice(0, -1).join(".");
}
