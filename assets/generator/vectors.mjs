// Points and directions are arrays of three numbers; matrices are arrays of twelve, row by row (3 x 4).

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
];
export const length = a => Math.hypot(a[0], a[1], a[2]);
export const unit = a => times(a, 1 / length(a));
export const radians = degrees => degrees * Math.PI / 180;

export const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

export function apply(m, p) {
    return [
        m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3],
        m[4] * p[0] + m[5] * p[1] + m[6] * p[2] + m[7],
        m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11],
    ];
}

/** The matrix that applies b first, then a. */
export function multiply(a, b) {
    const product = [];
    for (let row = 0; row < 12; row += 4) {
        for (let column = 0; column < 4; column++) {
            product.push(a[row] * b[column] + a[row + 1] * b[column + 4] + a[row + 2] * b[column + 8]
                + (column === 3 ? a[row + 3] : 0));
        }
    }
    return product;
}

export function determinant(m) {
    return dot([m[0], m[1], m[2]], cross([m[4], m[5], m[6]], [m[8], m[9], m[10]]));
}
