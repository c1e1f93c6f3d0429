/** What of others is in the release, and what made it: from the lock files and from Ivy's, with the checksums of what was fetched. */
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { inRoot, readJson } from './project.mjs';

const NPM_FOLDERS = ['', 'js/module/', 'js/playground/', 'js/adapters/three/'];

/** The packages that are in the zip, as a whole or in part: where, and as what. */
const INSIDE = {
	'flex-sdk': { folder: '', where: ['docs/asdoc'], licence: 'MPL-1.1', what: 'the templates of ASDoc: style sheets, scripts and pictures' },
	'@blockly/keyboard-navigation': { folder: 'js/playground/', where: ['playground'], what: 'reaches blocks by keys' },
	'@dimforge/rapier3d-compat': { folder: 'js/playground/', where: ['playground'], what: 'is measured beside the engine' },
	blockly: { folder: 'js/playground/', where: ['playground'], what: 'shows blocks' },
	kdbush: { folder: 'js/playground/', where: ['playground'], what: 'is measured beside the engine' },
	'qrcode-generator': { folder: 'js/playground/', where: ['playground'], what: 'draws QR codes' },
	three: { folder: 'js/playground/', where: ['playground'], what: 'draws' },
	typedoc: { folder: 'js/module/', where: ['docs/typedoc', 'playground/docs/api'], what: 'the style sheets and scripts of the JavaScript API\'s pages' },
	lunr: { folder: 'js/module/', where: ['docs/typedoc', 'playground/docs/api'], what: 'finds names in these pages' },
};

/** What Maven's packages say of their licences, by organisation. */
const MAVEN_LICENCES = {
	antlr: 'BSD License',
	args4j: 'MIT',
	'commons-cli': 'Apache-2.0',
	'commons-io': 'Apache-2.0',
	'commons-lang': 'Apache-2.0',
	'com.google.guava': 'Apache-2.0',
	'com.google.javascript': 'Apache-2.0',
	'org.antlr': 'BSD License',
	'org.apache.flex': 'Apache-2.0',
	'org.apache.royale.compiler': 'Apache-2.0',
	'org.b1.pack': 'Public Domain',
	'org.flexunit': 'MIT',
};

/**
 * What of others is in the zip.
 *
 * @typedef {{name: string, group?: string, version: string, licence?: string, purl: string, hash: [string, string], where?: string[],
 *     what?: string}} Part
 * @returns {Part[]} by name
 */
export function partsInside() {
	return Object.entries(INSIDE).map(([name, { folder, ...own }]) => ({ ...npmPart(folder, name), ...own }));
}

/** What the release was made and tested with, and is not in it. */
export function tools() {
	const all = new Map([...NPM_FOLDERS.flatMap(npmTools), ...ivyTools()].map((part) => [part.purl, part]));
	for (const { purl } of partsInside()) all.delete(purl);
	return [...all.values()];
}

function npmTools(folder) {
	return Object.keys(readJson(`${folder}package.json`).devDependencies).map((name) => npmPart(folder, name));
}

/** A package in a folder. An alias stands for a package of another name. */
function npmPart(folder, alias) {
	const { name = alias, version, license, integrity } = readJson(`${folder}package-lock.json`).packages[`node_modules/${alias}`];
	const [algorithm, checksum] = integrity.split(/-(.*)/);
	return {
		name,
		version,
		licence: license,
		purl: `pkg:npm/${name.replace('@', '%40')}@${version}`,
		hash: [algorithm.replace('sha', 'SHA-'), Buffer.from(checksum, 'base64').toString('hex')],
	};
}

function ivyTools() {
	const text = readFileSync(inRoot('build/ivy.xml'), 'utf8');
	return [...text.matchAll(/<dependency org="([^"]+)" name="([^"]+)" rev="([^"]+)"[^>]* conf="([^"]+)"/g)]
		.map(([, group, name, version, folder]) => {
			const artifact = `lib/${folder}/${name}-${version}${group === 'org.flexunit' ? '-as3.swc' : '.jar'}`;
			return {
				name,
				group,
				version,
				licence: MAVEN_LICENCES[group],
				purl: `pkg:maven/${group}/${name}@${version}`,
				hash: ['SHA-256', createHash('sha256').update(readFileSync(inRoot(artifact))).digest('hex')],
			};
		});
}
