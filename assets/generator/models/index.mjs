import { bear } from "./bear.mjs";
import { dragon } from "./dragon.mjs";
import { fireman } from "./fireman.mjs";
import { fortress } from "./fortress.mjs";
import { kelp } from "./kelp.mjs";
import { person } from "./person.mjs";
import { seagull } from "./seagull.mjs";
import { spaceship } from "./spaceship.mjs";
import { tree } from "./tree.mjs";

const obj = { format: "OBJ" };
const collada = { format: "COLLADA" };
const metre = { name: "metre", meter: 1 };
const decimetre = { name: "decimetre", meter: 0.1 };
const inch = { name: "inch", meter: 0.0254 };

// In the order of the thesis's Figure 6-1, each with the volumes that the figure gives for the thesis's own model.
export const models = [
    {
        name: "bear", build: bear, ...obj, withNormals: true,
        thesis: { boxVolume: 1.842, sphereVolume: 6.441 },
    },
    {
        name: "dragon", build: dragon, ...collada, unit: metre,
        thesis: { boxVolume: 0.298, sphereVolume: 0.598 },
    },
    {
        name: "seagull", build: seagull, ...collada, upAxis: "Y_UP", unit: inch,
        thesis: { boxVolume: 0.333, sphereVolume: 1.061 },
    },
    {
        name: "tree", build: tree, ...obj, withNormals: true,
        thesis: { boxVolume: 2.253, sphereVolume: 7.025 },
    },
    {
        name: "kelp", build: kelp, ...obj,
        thesis: { boxVolume: 0.011, sphereVolume: 0.524 },
    },
    {
        name: "fortress", build: fortress, ...obj,
        thesis: { boxVolume: 0.501, sphereVolume: 1.768 },
    },
    {
        name: "spaceship", build: spaceship, ...obj, withNormals: true,
        thesis: { boxVolume: 0.173, sphereVolume: 0.527 },
    },
    {
        name: "fireman", build: fireman, ...collada, unit: decimetre,
        thesis: { boxVolume: 1.733, sphereVolume: 7.909 },
    },
    {
        name: "person", build: person, ...collada, unit: decimetre,
        thesis: { boxVolume: 0.259, sphereVolume: 0.674 },
    },
];
