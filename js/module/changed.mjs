#!/usr/bin/env node
/**
 * Finds which classes of the tests' translation are out of date: those whose sources changed, and if one looks different from outside, all that use it,
 * directly or by others.
 *
 * node js/module/changed.mjs TRANSPILED OUT
 *
 * TRANSPILED is a translation of all classes, with its sources noted. OUT gets a main class for the compiler, and changed.properties: whole, if all classes
 * have to be compiled; otherwise classes, those to compile, if there are any. If all have to be, TRANSPILED is marked as not done.
 */
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { moduleRoots, testRoots } from "./names.mjs";
import { writeRoots } from "./roots.mjs";
import { outdated, readSources } from "./sources.mjs";

/** With more classes than these, compiling all takes about as long. */
const MOST = 200;

const [transpiled, out] = process.argv.slice(2);
const done = join(transpiled, "done");
const noted = join(transpiled, "roots/sources.json");

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
writeFileSync(join(out, "changed.properties"), properties());

function properties() {
	const isTranslated = (qname) => existsSync(join(transpiled, "out/bin/js-debug", `${qname.replaceAll(".", "/")}.js`));
	const classes = existsSync(done) && existsSync(noted) ? outdated(JSON.parse(readFileSync(noted, "utf8")), readSources(), isTranslated, new Set([...moduleRoots(), ...testRoots()])) : null;
	if (classes === null || classes.length > MOST) {
		rmSync(done, { force: true });
		return "whole=true\n";
	}
	if (classes.length === 0) return "";
	writeRoots(join(out, "roots"), []);
	writeFileSync(join(out, "classes.json"), JSON.stringify(classes));
	console.log(`translated anew: ${classes.length <= 8 ? classes.join(", ") : `${classes.length} classes`}`);
	return `classes=${classes.join(",")}\n`;
}
