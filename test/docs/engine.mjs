/** The copy of the ES module that the samples of the documentation import, for their preludes. */
export const engine = await import(new URL('../../bin/generated/docs-js/node_modules/starlogo-collision/starlogo-collision.js', import.meta.url).href);
