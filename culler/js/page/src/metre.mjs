// SPDX-License-Identifier: MIT

/**
 * A metre, or what stands for it where a model of this size is not as large as what one walks through.
 * @param {number} size
 */
export const metreOf = size => (size >= 3 && size <= 100000 ? 1 : size / 100);
