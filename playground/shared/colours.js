/** Colours of worlds. */

/** An agent's colour that leaves its model the colours it has. */
export const OWN_COLOURS = -1;

/** Of the outlines of agents. */
export const INK = 0x14202a;

/** Of the outlines where ground and sky are dark. */
const CHALK = 0xe6ecf5;

const MEADOW = {
	light: { zenith: 0x6fb3ea, horizon: 0xdff1fb, field: ["#a5de7d", "#95d46c"], around: ["#8fcb74", "#86c36b"], edge: 0xf7fbe9, ambient: 1.9, sun: 2.3, ink: INK },
	dark: { zenith: 0x6f78ad, horizon: 0xc98f6d, field: ["#7fae6d", "#73a262"], around: ["#6a9660", "#638e59"], edge: 0xe9e3c6, ambient: 1.5, sun: 1.9, ink: INK },
};
const SEA = {
	light: { zenith: 0x3d9bc4, horizon: 0xa9e2e4, field: ["#e3d3a0", "#d8c691"], around: ["#b9c7a2", "#afbe99"], edge: 0xfdf6dc, ambient: 1.8, sun: 2, ink: INK },
	dark: { zenith: 0x4b86a3, horizon: 0x7fb4ba, field: ["#b3a77f", "#a89c75"], around: ["#8f9c82", "#86937a"], edge: 0xe9e3c6, ambient: 1.4, sun: 1.7, ink: INK },
};
const NIGHT = { zenith: 0x05070f, horizon: 0x141b33, field: ["#1b2340", "#161d37"], around: ["#0c1122", "#0a0e1d"], edge: 0x5b6ea8, ambient: 1.9, sun: 2.3, ink: CHALK, stars: 500 };

/** Ground and sky, of which outlines stand out three to one, by day and at dusk. */
export const GROUNDS = { meadow: MEADOW, sea: SEA, space: { light: NIGHT, dark: NIGHT } };
