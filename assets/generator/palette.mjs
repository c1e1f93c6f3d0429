// The colours of all models, by the names that the files give to their materials.

export const palette = {
    brown_fur: "#7b4a22",
    light_fur: "#c08a52",
    black: "#1d1a19",
    ivory: "#efe6cf",
    bark: "#6e4a2c",
    leaf: "#3f8f36",
    bright_leaf: "#66b043",
    kelp: "#5b7a22",
    bright_kelp: "#8a9a2f",
    stone: "#b3aa98",
    dark_stone: "#8b8274",
    wood: "#5a3a20",
    roof: "#a5402f",
    hull: "#d5dae0",
    trim: "#c8322b",
    glass: "#3b8fd0",
    engine: "#4a4f57",
    glow: "#ffab2e",
    dragon: "#3c8a4a",
    dragon_belly: "#d9c56a",
    membrane: "#b5532f",
    horn: "#e5d9b8",
    white_feather: "#f4f4f1",
    grey_feather: "#9aa5b0",
    black_feather: "#2b2e33",
    beak: "#f0b429",
    skin: "#f0bf98",
    hair: "#4b2e1b",
    shirt: "#2f77c4",
    trousers: "#3a4766",
    shoe: "#6b3a25",
    coat: "#d9a632",
    reflective: "#e9efe2",
    helmet: "#cf2a22",
    boot: "#26262a",
    steel: "#9299a1",
};

/** The colour as three numbers from 0 to 1. */
export function channels(name) {
    const hex = palette[name];
    return [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16) / 255);
}
