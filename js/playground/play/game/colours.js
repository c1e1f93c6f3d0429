import { OWN_COLOURS } from "../../shared/drawing/colours.js";

/** The colours that blocks name. The first six are bright. The last one keeps a model's own colours. */
export const COLOURS = { red: 0xe5484d, orange: 0xf5a524, yellow: 0xf2d024, green: 0x46a758, blue: 0x3e7bfa, purple: 0x9b5de5, brown: 0x8a5a34, grey: 0x9aa4b2, white: 0xf4f4f0, own: OWN_COLOURS };
