// Writes the models of this directory and the table in its README, those of examples/three, which are some of them as glTF, and the level of
// examples/level.
//
//   node assets/generate.mjs           writes them
//   node assets/generate.mjs --check   writes nothing; fails if a file differs from what would be written

import { readFileSync, writeFileSync } from "node:fs";
import { collada } from "./generator/collada.mjs";
import { glb } from "./generator/gltf.mjs";
import { measure } from "./generator/measure.mjs";
import { mtl, obj } from "./generator/obj.mjs";
import { flatten } from "./generator/scene.mjs";
import { level } from "./generator/models/level.mjs";
import { models } from "./generator/models/index.mjs";
import { withTable } from "./generator/readme.mjs";

const here = name => new URL(name, import.meta.url);
const read = name => {
    try {
        return readFileSync(here(name), name.endsWith(".glb") ? "latin1" : "utf8");
    } catch {
        return "";
    }
};

// of the example with three.js
const GLTF = new Set(["bear", "seagull", "tree"]);
const files = new Map();
const rows = [];
const objColours = new Set();
for (const model of models) {
    const nodes = model.build();
    const file = `${model.name}.${model.format === "COLLADA" ? "dae" : "obj"}`;
    files.set(file, model.format === "COLLADA" ? collada({ ...model, nodes }) : obj({ ...model, nodes }));
    if (GLTF.has(model.name)) {
        files.set(`../examples/three/${model.name}.glb`, glb({ ...model, nodes }).toString("latin1"));
    }
    rows.push({ ...model, file, ...measure(nodes) });
    if (model.format !== "COLLADA") {
        flatten(nodes).forEach(part => objColours.add(part.colour));
    }
}
files.set("../examples/level/level.glb", glb({ name: "level", nodes: level() }).toString("latin1"));
files.set("palette.mtl", mtl(objColours));
files.set("README.md", withTable(read("README.md"), rows));

const different = [...files.keys()].filter(name => read(name) !== files.get(name));
if (process.argv.includes("--check")) {
    different.forEach(name => console.error(`assets/${name} is not what the generator writes`));
    process.exitCode = different.length > 0 ? 1 : 0;
} else {
    different.forEach(name => {
        writeFileSync(here(name), files.get(name), name.endsWith(".glb") ? "latin1" : "utf8");
        console.log(`wrote assets/${name}`);
    });
}
