import { existsSync, readFileSync } from 'node:fs';
import { refuse } from '../../build/refuse.mjs';

/**
 * The report that a run is compared with.
 *
 * @param {string} file its report.json
 * @throws {Error} with a line for the user, if it is no report
 */
export function olderReport(file) {
	if (!existsSync(file)) {
		throw new Error(`-Dcompare: there is no file ${file}`);
	}
	try {
		const report = JSON.parse(readFileSync(file, 'utf8'));
		if (Array.isArray(report.entries) && report.created && report.machine) {
			return report;
		}
	} catch {
		// said below
	}
	throw new Error(`-Dcompare: ${file} is no report.json of ./antw timing`);
}

/** The same for a program: undefined if no file is given; a report that cannot be read ends it with status 64, before it measures anything. */
export function olderReportOrEnd(file) {
	try {
		return file ? olderReport(file) : undefined;
	} catch (error) {
		return refuse(error.message);
	}
}
