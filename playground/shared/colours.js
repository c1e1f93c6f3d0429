/** Colours of worlds. */

/** An agent's colour that leaves its model the colours it has. */
export const OWN_COLOURS = -1;

/** Of the outlines of agents. */
export const INK = 0x14202a;

/** Ground and sky, so light that outlines stand out from them three to one, by day and at dusk. */
export const LANDS = {
	light: { zenith: 0x6fb3ea, horizon: 0xdff1fb, field: ["#a5de7d", "#95d46c"], around: ["#8fcb74", "#86c36b"], edge: 0xf7fbe9, ambient: 1.9, sun: 2.3 },
	dark: { zenith: 0x6f78ad, horizon: 0xc98f6d, field: ["#7fae6d", "#73a262"], around: ["#6a9660", "#638e59"], edge: 0xe9e3c6, ambient: 1.5, sun: 1.9 },
};
