// SPDX-License-Identifier: BSD-2-Clause
// Vectors, poses [R p] of 12 numbers row by row, and small dense systems.

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = a => Math.sqrt(dot(a, a));
const unit = a => scaled(a, 1 / (norm(a) || 1));

const turned = (T, v) => [
  T[0] * v[0] + T[1] * v[1] + T[2] * v[2],
  T[4] * v[0] + T[5] * v[1] + T[6] * v[2],
  T[8] * v[0] + T[9] * v[1] + T[10] * v[2]];
const moved = (T, v) => add(turned(T, v), [T[3], T[7], T[11]]);
const product = (A, B) => {
  const C = new Array(12);
  for (let i = 0; i < 3; ++i)
    for (let j = 0; j < 4; ++j)
      C[4 * i + j] = A[4 * i] * B[j] + A[4 * i + 1] * B[4 + j] + A[4 * i + 2] * B[8 + j] +
        (j === 3 ? A[4 * i + 3] : 0);
  return C;
};
const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

/// `v` turned by `angle` about the unit vector `axis`.
const rotated = (v, axis, angle) => {
  const c = Math.cos(angle), s = Math.sin(angle);
  return add(add(scaled(v, c), scaled(cross(axis, v), s)), scaled(axis, dot(axis, v) * (1 - c)));
};

/// Solves A x = b, A an array of rows, with pivots; null where A is singular.
const solved = (A, b) => {
  const n = b.length, M = A.map((row, i) => [...row, b[i]]);
  let largest = 0;
  for (const row of A) for (const value of row) largest = Math.max(largest, Math.abs(value));
  for (let k = 0; k < n; ++k) {
    let best = k;
    for (let i = k + 1; i < n; ++i) if (Math.abs(M[i][k]) > Math.abs(M[best][k])) best = i;
    if (!(Math.abs(M[best][k]) > 1e-13 * largest)) return null;
    [M[k], M[best]] = [M[best], M[k]];
    for (let i = k + 1; i < n; ++i) {
      const factor = M[i][k] / M[k][k];
      for (let j = k; factor !== 0 && j <= n; ++j) M[i][j] -= factor * M[k][j];
    }
  }
  const x = new Array(n);
  for (let k = n - 1; k >= 0; --k) {
    let rest = M[k][n];
    for (let j = k + 1; j < n; ++j) rest -= M[k][j] * x[j];
    x[k] = rest / M[k][k];
  }
  return x;
};

/// Eigenvalues, rising, and unit eigenvectors of a symmetric 3 x 3 matrix, by Jacobi's rotations.
const eigen3 = given => {
  const A = given.map(row => [...row]), V = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (let sweep = 0; sweep < 30; ++sweep)
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (A[p][q] === 0) continue;
      const theta = (A[q][q] - A[p][p]) / (2 * A[p][q]);
      const t = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
      const c = 1 / Math.sqrt(t * t + 1), s = t * c;
      for (let k = 0; k < 3; ++k) {
        const x = A[k][p], y = A[k][q];
        A[k][p] = c * x - s * y;
        A[k][q] = s * x + c * y;
      }
      for (let k = 0; k < 3; ++k) {
        const x = A[p][k], y = A[q][k];
        A[p][k] = c * x - s * y;
        A[q][k] = s * x + c * y;
      }
      for (let k = 0; k < 3; ++k) {
        const x = V[k][p], y = V[k][q];
        V[k][p] = c * x - s * y;
        V[k][q] = s * x + c * y;
      }
    }
  const order = [0, 1, 2].sort((i, j) => A[i][i] - A[j][j]);
  return { values: order.map(i => A[i][i]), vectors: order.map(i => V.map(row => row[i])) };
};

/// The k-th point of Halton's sequence in n dimensions, each in 0..1: even, and the same always.
const primes = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79];
const halton = (k, n) => {
  const point = [];
  for (let d = 0; d < n; ++d) {
    const base = primes[d % primes.length];
    let value = 0, share = 1;
    for (let i = k + 1 + 37 * Math.floor(d / primes.length); i > 0; i = Math.floor(i / base)) {
      share /= base;
      value += share * (i % base);
    }
    point.push(value);
  }
  return point;
};
