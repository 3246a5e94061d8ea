// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sinew {

enum class Scalar { binary64, binary32 };

/// What the emitted C is short of: time, or room for code.
enum class Optimise { speed, size };

/// What the emitted C is meant to run on.
struct Target {
  Scalar scalar = Scalar::binary64;
  /// Multiplications and additions may be fused. The processor must have the instruction: the C does
  /// not compile without it. Where nothing is fused by the compiler itself (-ffp-contract=off), all
  /// such processors and the interpreter give the same bits.
  bool fused = false;
  Optimise optimise = Optimise::speed;
  const char* type() const { return scalar == Scalar::binary64 ? "double" : "float"; }
  /// Suffix of the runtime's functions and of literals.
  const char* suffix() const { return scalar == Scalar::binary64 ? "" : "f"; }
  int bytes() const { return scalar == Scalar::binary64 ? 8 : 4; }
};

}  // namespace sinew
