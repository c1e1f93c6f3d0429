/** The colours in worlds. A colour has the same meaning in every view. A sign says the same without colour. */

/**
 * The verdicts about agents, pairs and surrounding shapes. "hit" is a touch that is found. "wrong" is a false collision, or one that only
 * one system finds. "missed" is a touch that is not found, or that only another system finds. "none" touches nothing. Their brightness
 * differs too, for people who cannot tell red from green.
 */
export const VERDICTS = { hit: 0xd62f5a, wrong: 0xffb000, missed: 0x6a3df0, none: 0x8c98a9 };

/** The shapes that the engine tests, a level of its trees, a distance, a ray, and the selected agent: by day and by night. */
export const LINES = {
	tested: { light: 0x1667c9, dark: 0x5ea4ff }, level: { light: 0x0a2f73, dark: 0xb8d6ff }, distance: { light: 0x0b7a5f, dark: 0x4fd8b0 }, ray: { light: 0x1c2430, dark: 0xf2f5fa },
	chosen: { light: 0x1c2430, dark: 0x1c2430 },
};

/** Agents without a verdict: the first one, and others. */
export const AGENTS = { first: 0x9db6dc, other: 0xb9d3c4 };

/** Two agents that touch, in colours that differ. */
export const TOUCHING = [0xb81f49, 0xe9708f];

const css = (colour) => `#${colour.toString(16).padStart(6, "0")}`;

/** Makes the colours available to style sheets: --hit, --wrong and so on, --tested, --tested-dark and so on. */
export function setColourProperties({ style }) {
	for (const [name, colour] of Object.entries(VERDICTS)) style.setProperty(`--${name}`, css(colour));
	for (const [name, { light, dark }] of Object.entries(LINES)) {
		style.setProperty(`--${name}-light`, css(light));
		style.setProperty(`--${name}-dark`, css(dark));
	}
}

/** An agent's colour that keeps the model's own colours. */
export const OWN_COLOURS = -1;

/** The agents' outlines. */
export const INK = 0x14202a;

/** The outlines if ground and sky are dark. */
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

/** Ground and sky by day and at dusk. Outlines have a contrast of three to one against them. */
export const GROUNDS = { meadow: MEADOW, sea: SEA, space: { light: NIGHT, dark: NIGHT } };
