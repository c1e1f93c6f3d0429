/** A number with so many significant digits, not in scientific notation. */
export function significant(value, digits) {
	if (value === 0) {
		return '0';
	}
	const rounded = Number(value.toPrecision(digits));
	const decimals = digits - 1 - Math.floor(Math.log10(Math.abs(rounded)));
	return rounded.toFixed(Math.min(Math.max(decimals, 0), digits));
}

const unitOf = (ms) => (ms < 0.0009995 ? [1e6, 'ns'] : ms < 0.9995 ? [1e3, 'µs'] : ms < 9999.5 ? [1, 'ms'] : [1e-3, 's']);

/** Milliseconds in the unit that suits them. */
export function time(ms) {
	const [factor, unit] = unitOf(ms);
	return `${significant(ms * factor, 3)} ${unit}`;
}

/** The same with all digits: a number of the thesis as it stands there. */
export function quoted(ms) {
	const [factor, unit] = unitOf(ms);
	return `${Number((ms * factor).toPrecision(9))} ${unit}`;
}

/** How many times as much: two significant digits, three of large numbers. */
export function ratio(value) {
	return `${value < 99.5 ? significant(value, 2) : Number(value.toPrecision(3)).toLocaleString('en')}×`;
}

/** A part in hundredths. */
export function percent(part) {
	return `${Math.round(part * 100)} %`;
}
