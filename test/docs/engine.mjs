/** The copies of the ES module and of its adapter to three.js that the samples of the documentation import, for their preludes. */
const copyOf = (file) => import(new URL(`../../bin/generated/docs-js/node_modules/starlogo-collision/${file}`, import.meta.url).href);

export const engine = await copyOf('starlogo-collision.js');
export const adapter = await copyOf('three/index.js');
