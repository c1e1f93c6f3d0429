const COLUMNS = ['figure', 'subject', 'variant', 'value', 'unit', 'low', 'high', 'samples', 'multiple', 'multipleLow',
	'multipleHigh', 'beside', 'thesis', 'refused', 'vertices', 'tightest', 'agents', 'collisions', 'agrees', 'busy'];

/** The entries as comma-separated values (RFC 4180), a head line first. */
export function csv(entries) {
	return [COLUMNS, ...entries.map((entry) => COLUMNS.map((column) => entry[column]))]
		.map((row) => row.map(quote).join(',') + '\r\n').join('');
}

function quote(value) {
	const text = String(value ?? '');
	return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
