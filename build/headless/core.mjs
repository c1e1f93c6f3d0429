#!/usr/bin/env node
/**
 * Leaves of a library of declarations of the player's classes only those that Adobe's VM has without a player, so that sources
 * compiled against it take flash.geom, flash.events and the like from the stand-ins (js/standins/).
 *
 *   node build/headless/core.mjs in out      folders with the catalog.xml and library.swf of a SWC
 */
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { readSwf, stringAt, writeSwf } from './swf.mjs';

const DO_ABC = 82;
const FLASH_NAMES = new Set(['flash.utils:ByteArray', 'flash.utils:IDataInput', 'flash.utils:IDataOutput', 'flash.utils:Dictionary',
	'flash.utils:Endian', 'flash.utils:IExternalizable', 'flash.utils:Proxy', 'flash.utils:flash_proxy', 'flash.utils:CompressionAlgorithm',
	'flash.errors:IOError', 'flash.errors:EOFError', 'flash.errors:MemoryError', 'flash.errors:IllegalOperationError',
	'flash.net:ObjectEncoding']);

const [from, to] = process.argv.slice(2);
const kept = new Set();
const catalog = (await readFile(path.join(from, 'catalog.xml'), 'utf8')).replace(/\s*<script [^]*?<\/script>/g, (script) => {
	const names = [...script.matchAll(/<def id="([^"]+)"/g)].map((match) => match[1]);
	if (!names.some(isOfTheVm) || names.includes('flash.utils:describeType')) {
		return '';
	}
	kept.add(/name="([^"]+)"/.exec(script)[1]);
	return script;
});
const library = readSwf(await readFile(path.join(from, 'library.swf')));
library.tags = library.tags.filter(({ code, content }) => code !== DO_ABC || kept.has(stringAt(content, 4)));
await mkdir(to, { recursive: true });
await writeFile(path.join(to, 'catalog.xml'), catalog);
await writeFile(path.join(to, 'library.swf'), writeSwf(library));

function isOfTheVm(name) {
	return FLASH_NAMES.has(name) || name.startsWith('__AS3__') || (!name.includes(':') && !name.startsWith('_a9'));
}
