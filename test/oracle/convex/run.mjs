#!/usr/bin/env node
/**
 * Random pairs of convex bodies against exact arithmetic.
 *
 *   node test/oracle/convex/run.mjs COUNT [SEED] [ENGINE] [FAMILY]
 *
 * COUNT pairs in all, of all families and kinds alike. ENGINE is one of engines.mjs: core, the default, or another. ./antw convex makes the compiled classes
 * that are asked.
 */
import { pathToFileURL } from "node:url";
import { widened } from "./bodies.mjs";
import { Tally, checkPair } from "./check.mjs";
import { ENGINES } from "./engines.mjs";
import { FAMILIES, KIND_PAIRS, drawMotion, drawPair } from "./families.mjs";

/** What is exactly on a lattice is just beside it in every so many pairs: as much wider as shapes are that touch up to the documented gap. */
const EVERY = 4;
const WIDER = 1 + 4e-14;

/** From so many pairs on, each family and each pair of kinds has a line. */
const MANY = 10000;

/** Checks pairs of all families and kinds of an engine: a Tally for each family and each pair of kinds. */
export function checkMany(engine, count, seed, families = FAMILIES) {
	const kinds = KIND_PAIRS.filter((pair) => pair.every((kind) => engine.kinds.includes(kind)));
	const each = Math.max(1, Math.round(count / (families.length * kinds.length)));
	const tallies = new Map();
	for (const family of families) {
		for (const [i, pair] of kinds.entries()) {
			const tally = new Tally();
			tallies.set(`${family}, ${pair.join("-")}`, tally);
			for (let k = 0; k < each; k++) {
				const from = seed + 1000003 * FAMILIES.indexOf(family) + 10007 * i * 17 + k;
				const [first, second] = k % 2 === 0 ? pair : [pair[1], pair[0]];
				const drawn = drawPair(family, first, second, from);
				const isWider = family === "lattice" && k % EVERY === EVERY - 1;
				const [a, b] = [drawn.a, drawn.b].map((one) => (isWider ? widened(one, WIDER) : one)).map((one) => engine.asMade?.(one) ?? one);
				checkPair(engine, { ...drawn, a, b, motion: drawMotion(drawn) }, tally);
			}
		}
	}
	return tallies;
}

/** The sum of some tallies. */
export function total(tallies) {
	const all = new Tally();
	for (const tally of tallies) {
		for (const [what, count] of tally.counts) all.counts.set(what, (all.counts.get(what) ?? 0) + count);
		for (const [what, cases] of tally.wrong) all.wrong.set(what, [...(all.wrong.get(what) ?? []), ...cases]);
		for (const [what, part] of Object.entries(tally.worst)) all.worst[what] = Math.max(all.worst[what], part);
	}
	return all;
}

const textOf = (tally) => `${[...tally.counts].map(([what, count]) => `${count} ${what}`).join(", ")}; worst, as a part of what is allowed: ${
	Object.entries(tally.worst).map(([what, part]) => `${what} ${part.toPrecision(2)}`).join(", ")}`;

async function main([count = "3000", seed = "1", name = "core", family]) {
	const classes = await import(new URL("../../../bin/generated/module/tests.mjs", import.meta.url));
	const engine = new ENGINES[name](classes);
	const tallies = checkMany(engine, Number(count), Number(seed), family === undefined ? FAMILIES : [family]);
	for (const part of Number(count) < MANY ? [] : [...FAMILIES, ...KIND_PAIRS.map((pair) => pair.join("-"))]) {
		const some = [...tallies].filter(([key]) => key.split(", ").includes(part)).map(([, tally]) => tally);
		if (some.length > 0) console.log(`${part}: ${textOf(total(some))}`);
	}
	const all = total(tallies.values());
	console.log(`convex shapes and exact arithmetic: ${textOf(all)}`);
	for (const [what, cases] of all.wrong) {
		console.log(`WRONG, ${what}: ${cases.length}`);
		for (const each of cases.slice(0, 5)) console.log(`  ${each.family}, ${each.kinds}, seed ${each.seed}: ${each.details}`);
	}
	process.exitCode = all.wrongCount > 0 ? 1 : 0;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) await main(process.argv.slice(2));
