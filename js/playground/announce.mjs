/** Where a served page can be opened: its addresses, and a QR code for the terminal. */
import qrcode from "qrcode-generator";

const ANYWHERE = ["0.0.0.0", "::"];
/** The light modules around a code. Readers need four of them. */
const QUIET = 4;
/** Two modules, one above the other, as a character: the upper one is dark, the lower one, both, or none. */
const HALVES = { "10": "▀", "01": "▄", "11": "█", "00": " " };

/**
 * The addresses at which a server can be reached.
 *
 * @param {string} host the address that it listens on
 * @param {number} port
 * @param {Record<string, {address: string, family: string, internal: boolean}[]>} interfaces of the machine, as os.networkInterfaces gives them
 */
export function addressesOf(host, port, interfaces) {
	if (!ANYWHERE.includes(host)) return [`http://${host}:${port}/`];
	const all = Object.values(interfaces).flat().filter(({ family, internal }) => family === "IPv4" && !internal);
	return (all.length > 0 ? all.map(({ address }) => address) : ["127.0.0.1"]).map((address) => `http://${address}:${port}/`);
}

/**
 * A QR code as lines of text. It is dark on light in terminals of both kinds, because it sets both colours.
 *
 * @param {string} text
 * @param {boolean} hasBlocks whether the terminal shows characters beyond ASCII; without them the code is four times as large
 */
export function qrOf(text, hasBlocks) {
	const code = qrcode(0, "M");
	code.addData(text);
	code.make();
	const count = code.getModuleCount();
	const isDark = (row, column) => row >= 0 && column >= 0 && row < count && column < count && code.isDark(row, column);
	const range = (step) => Array.from({ length: Math.ceil((count + 2 * QUIET) / step) }, (_, i) => i * step - QUIET);
	if (!hasBlocks) return range(1).map((row) => `${range(1).map((column) => (isDark(row, column) ? "\x1b[40m  " : "\x1b[107m  ")).join("")}\x1b[0m`);
	return range(2).map((row) => `\x1b[30;107m${range(1).map((column) => HALVES[`${Number(isDark(row, column))}${Number(isDark(row + 1, column))}`]).join("")}\x1b[0m`);
}
