#!/usr/bin/env node
/**
 * Writes the samples in ActionScript of the documentation as test classes. A file that is the same keeps its time: nothing is compiled again
 * for it.
 *
 *   node test/docs/write.mjs bin/generated/docs
 */
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pages, testClasses } from './samples.mjs';

const [folder] = process.argv.slice(2);
const files = testClasses(pages());
mkdirSync(folder, { recursive: true });
for (const file of readdirSync(folder, { recursive: true })) {
	if (file.endsWith('.as') && !files.has(file)) {
		rmSync(path.join(folder, file));
	}
}
for (const [file, text] of files) {
	const to = path.join(folder, file);
	if (!existsSync(to) || readFileSync(to, 'utf8') !== text) {
		mkdirSync(path.dirname(to), { recursive: true });
		writeFileSync(to, text);
	}
}
