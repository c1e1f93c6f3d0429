/** An agent's colour that leaves its model the colours it has. */
export const OWN_COLOURS = -1;
