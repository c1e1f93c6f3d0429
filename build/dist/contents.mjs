/** What is in the release, by the name that it has there. */
import { readFileSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { partsInside } from './parts.mjs';
import { NAME, VERSION, inRoot } from './project.mjs';
import { normaliseSwc, normaliseSwf } from './swc.mjs';

const ASDOC_DATE = /<br\/>\w{3} \w{3} \d+ \d{4}, \d\d:\d\d [AP]M \w+ */g;
const MPL = 'node_modules/flex-sdk/lib/flex_sdk/license-mpl.htm';

/**
 * Reads all that goes into the release.
 *
 * @param {string} bin where everything was built
 * @param {string} cooked the folder of the models with their fits
 * @param {number} seconds the time of the release, of the Unix epoch
 * @returns {Map<string, Uint8Array>}
 */
export function contents(bin, cooked, seconds) {
	const files = new Map();
	const add = (name, file) => files.set(name, normalised(name, readFileSync(file), seconds));
	const addFolder = (name, folder, isIn = () => true) => {
		for (const file of filesIn(folder).filter(isIn)) {
			add(`${name}/${file}`, path.join(folder, file));
		}
	};
	for (const name of ['README.md', 'CONTRIBUTING.md', 'CHANGELOG.md', 'LICENSE', 'lib/README.md']) {
		add(name, inRoot(name));
	}
	addFolder('docs', inRoot('docs'));
	addFolder('docs/asdoc', path.join(bin, 'dist/asdoc'));
	addFolder('docs/typedoc', path.join(bin, 'typedoc'));
	addFolder('swc', path.join(bin, 'dist'), (file) => file.endsWith('.swc'));
	addFolder('module', path.join(bin, 'module'));
	addFolder('playground', path.join(bin, 'playground'));
	addFolder('assets', cooked);
	addFolder('examples', inRoot('examples'));
	addFolder('examples/flash', path.join(bin, 'dist/examples/flash'));
	add('licences/MPL-1.1.html', inRoot(MPL));
	for (const name of ['typedoc', 'lunr']) add(`licences/${name}.txt`, inRoot(`js/module/node_modules/${name}/LICENSE`));
	files.set('licences/README.md', Buffer.from(licences()));
	return files;
}

function filesIn(folder) {
	return readdirSync(folder, { recursive: true }).filter((file) => statSync(path.join(folder, file)).isFile())
		.map((file) => file.replaceAll('\\', '/'));
}

function normalised(name, content, seconds) {
	if (name.endsWith('.swc')) {
		return normaliseSwc(content, seconds, { LICENSE: readFileSync(inRoot('LICENSE')), VERSION: Buffer.from(`${NAME} ${VERSION}\n`) });
	}
	if (name.endsWith('.swf')) {
		return normaliseSwf(content, seconds);
	}
	if (name.startsWith('docs/asdoc/') && name.endsWith('.html')) {
		return Buffer.from(content.toString('utf8').replaceAll(ASDOC_DATE, ''));
	}
	// the zip has the parts of js/ at its top
	return name.endsWith('.md') ? Buffer.from(content.toString('utf8').replaceAll(/\]\(((?:\.\.\/)*)js\//g, ']($1')) : content;
}

function licences() {
	const rows = partsInside().map(({ name, version, licence, where, what }) => `| ${name} ${version} | ${what} | ${licence} | ${where.join(', ')} |`);
	return `# Licences

The engine, the playground, the documentation and the examples are under the MIT licence (\`LICENSE\`). The models in \`assets\` are in the public
domain (CC0, \`assets/LICENSE\`).

Of others:

| | what it does | licence | in |
|---|---|---|---|
${rows.join('\n')}

The texts: \`playground/LICENSES.txt\` for the playground, \`licences/MPL-1.1.html\` for ASDoc's templates,
which are as the Flex SDK has them in its folder \`asdoc/templates\`, but for what is added at the end of \`asdoc.js\`;
\`licences/typedoc.txt\` and \`licences/lunr.txt\` for the JavaScript API's pages. The SWCs and the module have nothing of others in them. \`sbom.cdx.json\` lists all of
this for programs, and the tools that made it.
`;
}
