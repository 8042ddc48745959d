// What points are named by: a number, and a kind.

// It stands for no point, no pair, and infinity.
export const none = 0xffffffff;

// Kinds of points: the index, or 4 for regular stationary.
export const regular_kind = 4;
