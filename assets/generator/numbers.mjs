/** A number as the files write it: five decimals at most, no superfluous zeros, no minus zero. */
export function decimal(value, places = 5) {
    const text = value.toFixed(places).replace(/\.?0+$/, "");
    return text === "-0" ? "0" : text;
}

export const decimals = (values, places) => values.map(value => decimal(value, places)).join(" ");
