const START = "<!-- table: written by generate.mjs -->";
const END = "<!-- end of table -->";

/** The README with the table of models between its two markers. */
export function withTable(text, models) {
    const before = text.indexOf(START);
    const after = text.indexOf(END);
    if (before < 0 || after < before) {
        throw new Error(`README.md needs the lines "${START}" and "${END}"`);
    }
    return text.slice(0, before) + [START, ...table(models), END].join("\n") + text.slice(after + END.length);
}

function table(models) {
    return [
        "| model | file | vertices | triangles | extents x, y, z | box volume (thesis) | sphere volume (thesis) |",
        "|---|---|---:|---:|---|---|---|",
        ...models.map(({ name, file, vertices, triangles, extents, boxVolume, sphereVolume, thesis }) => "| " + [
            name, file, vertices, triangles, extents.map(extent => extent.toFixed(3)).join(", "),
            `${boxVolume.toFixed(3)} (${thesis.boxVolume.toFixed(3)})`,
            `${sphereVolume.toFixed(3)} (${thesis.sphereVolume.toFixed(3)})`,
        ].join(" | ") + " |"),
    ];
}
