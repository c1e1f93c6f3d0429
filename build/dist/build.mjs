#!/usr/bin/env node
/**
 * Puts the release into one zip, the same bytes wherever it is built, and its checksum beside it.
 *
 *   node build/dist/build.mjs BIN COOKED      where all was built, and the folder of the models with their fits
 */
import { createHash } from 'node:crypto';
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { contents } from './contents.mjs';
import { NAME, VERSION, releaseTime } from './project.mjs';
import { sbom } from './sbom.mjs';
import { zip } from './zip.mjs';

const [bin, cooked] = process.argv.slice(2);
const release = `${NAME}-${VERSION}`;
const seconds = releaseTime();

const files = contents(bin, cooked, seconds);
files.set('sbom.cdx.json', Buffer.from(sbom(files, seconds)));
files.set('SHA256SUMS', Buffer.from([...files].map(([name, content]) => checksumLine(name, content)).sort(byName).join('')));
const archive = zip(new Map([...files].map(([name, content]) => [`${release}/${name}`, content])), seconds);
const target = path.join(bin, `${release}.zip`);
writeFileSync(target, archive);
const line = checksumLine(`${release}.zip`, archive);
writeFileSync(`${target}.sha256`, line);
console.log(`written: ${target} (${files.size} files, ${(archive.length / 1e6).toFixed(1)} MB)\nsha256: ${line.split(' ')[0]}`);

/** As sha256sum prints and checks it. */
function checksumLine(name, content) {
	return `${createHash('sha256').update(content).digest('hex')}  ${name}\n`;
}

function byName(one, other) {
	return one.slice(64) < other.slice(64) ? -1 : 1;
}
