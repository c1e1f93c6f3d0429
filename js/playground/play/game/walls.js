/** A wall that is longer, in patches, is built of several. */
const LONGEST = 4;

const isAlongX = (from, to) => Math.abs(to.x - from.x) >= Math.abs(to.y - from.y);

/** Where a wall from one place towards another ends: it goes along x or y. */
export const endOfWall = (from, to) => (isAlongX(from, to) ? { x: to.x, y: from.y } : { x: from.x, y: to.y });

/** Walls from one place to another, along x or y: the middle, the heading and the length of each. */
export function wallsBetween(from, to) {
	const isX = isAlongX(from, to);
	const [begin, end] = isX ? [from.x, to.x] : [from.y, to.y];
	const count = Math.ceil(Math.abs(end - begin) / LONGEST);
	// they begin and end on whole patches
	const borders = Array.from({ length: count + 1 }, (_, i) => begin + Math.round((i * (end - begin)) / count));
	return borders.slice(1).map((border, i) => {
		const middle = (borders[i] + border) / 2;
		return [isX ? middle : from.x, isX ? from.y : middle, isX ? 90 : 0, Math.abs(border - borders[i])];
	});
}
