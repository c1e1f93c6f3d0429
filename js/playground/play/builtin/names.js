/** The lessons in their order. */
export const LESSON_NAMES = ["blocks", "helmet", "wing", "main", "fast", "starts", "room", "near", "see", "hunt", "jump"];
