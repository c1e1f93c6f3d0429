/** What scripts that play a SWF are given. */
import { readFile } from 'node:fs/promises';
import { parseArgs } from 'node:util';
import { thereIs } from '../nearest.mjs';
import { pairs } from './pairs.mjs';
import { problemOf } from './swf.mjs';

/** An error that ends the script with an exit status: 64 for wrong arguments. */
export class RunError extends Error {
	constructor(message, status = 64) {
		super(message);
		this.status = status;
	}
}

/** The options of all these scripts. */
const SHARED = {
	param: { type: 'string', multiple: true, default: [] },
	mount: { type: 'string', multiple: true, default: [] },
};

/**
 * The SWF and the options as they were given, with what they name.
 *
 * @param {object} [own] the script's own options, as for parseArgs()
 * @throws {RunError} if one is wrong. It names the nearest
 */
export function parsed(own) {
	const known = { ...SHARED, ...own };
	try {
		const { values, positionals } = parseArgs({ allowPositionals: true, options: known });
		if (positionals.length !== 1) throw new Error('exactly one SWF must be given');
		return { swf: positionals[0], values, parameters: pairs(values.param), folders: pairs(values.mount) };
	} catch (error) {
		const [, unknown] = /^Unknown option '--?([^']+)'/.exec(error.message) ?? [];
		throw new RunError(unknown ? `there is no option --${unknown}${thereIs(unknown, Object.keys(known), '--')}` : error.message);
	}
}

/** Throws a RunError if there is no whole SWF at a path. */
export async function requireSwf(swf) {
	const file = await readFile(swf).catch(() => {
		throw new RunError(`there is no SWF at ${swf}`);
	});
	const problem = problemOf(file);
	if (problem) throw new RunError(`${swf} ${problem}`);
}
