import { createHash } from 'node:crypto';
import { Enums, Models, SPDX, Serialize, Spec } from '@cyclonedx/cyclonedx-library';
import { partsInside, tools } from './parts.mjs';
import { NAME, VERSION } from './project.mjs';

const { ComponentScope, ComponentType, HashAlgorithm } = Enums;

/** Files of our own that are used by themselves. */
const PRODUCTS = /^(swc|module)\/[^/]*\.(swc|js)$/;

/**
 * The release's bill of materials, CycloneDX 1.6 in JSON: itself with its products, what of others is in it, and, of scope "excluded",
 * what it was made and tested with.
 *
 * @param {Map<string, Uint8Array>} files what is in the release
 * @param {number} seconds its time, of the Unix epoch
 * @returns {string}
 */
export function sbom(files, seconds) {
	const inside = partsInside().map((part) => component(part, ComponentScope.Required));
	const bom = new Models.Bom({
		metadata: new Models.Metadata({ timestamp: new Date(seconds * 1000), component: release(files, inside) }),
		components: new Models.ComponentRepository([...inside, ...tools().map((part) => component(part, ComponentScope.Excluded))]),
	});
	bom.serialNumber = serialNumber(serialized(bom));
	return `${serialized(bom)}\n`;
}

function serialized(bom) {
	const factory = new Serialize.JSON.Normalize.Factory(Spec.Spec1dot6);
	return new Serialize.JsonSerializer(factory).serialize(bom, { sortLists: true, space: 2 });
}

/** A UUID of version 8, made of the content. */
function serialNumber(content) {
	const hex = createHash('sha256').update(content).digest('hex');
	return `urn:uuid:${hex.slice(0, 8)}-${hex.slice(8, 12)}-8${hex.slice(13, 16)}-8${hex.slice(17, 20)}-${hex.slice(20, 32)}`;
}

function release(files, inside) {
	const own = new Models.Component(ComponentType.Library, NAME, {
		version: VERSION,
		bomRef: `pkg:generic/${NAME}@${VERSION}`,
		purl: `pkg:generic/${NAME}@${VERSION}`,
		description: 'The collision engine of StarLogo Nova, with models of a game in the public domain (CC0-1.0)',
		licenses: new Models.LicenseRepository([new Models.LicenseExpression('MIT AND CC0-1.0')]),
	});
	for (const { bomRef } of inside) {
		own.dependencies.add(bomRef);
	}
	for (const [name, content] of files) {
		if (PRODUCTS.test(name)) {
			own.components.add(new Models.Component(ComponentType.File, name, {
				version: VERSION,
				bomRef: name,
				licenses: new Models.LicenseRepository([new Models.SpdxLicense('MIT')]),
				hashes: new Models.HashDictionary([[HashAlgorithm['SHA-256'], createHash('sha256').update(content).digest('hex')]]),
			}));
		}
	}
	return own;
}

function component({ name, group, version, licence, purl, hash, where, what }, scope) {
	return new Models.Component(ComponentType.Library, name, {
		group,
		version,
		purl,
		scope,
		bomRef: purl,
		description: where && `${what}; in ${where.join(', ')}`,
		licenses: new Models.LicenseRepository(licence ? [licenceOf(licence)] : []),
		hashes: new Models.HashDictionary([hash]),
	});
}

function licenceOf(text) {
	if (/ (AND|OR) /.test(text)) {
		return new Models.LicenseExpression(text);
	}
	return SPDX.isSupportedSpdxId(text) ? new Models.SpdxLicense(text) : new Models.NamedLicense(text);
}
