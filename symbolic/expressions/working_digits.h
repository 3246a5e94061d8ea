// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

namespace sinew {

/// Sets the number of decimal digits GiNaC computes with, for as long as it lives. GiNaC keeps that
/// number in one global; it is put back on every way out.
class WorkingDigits {
 public:
  explicit WorkingDigits(int digits) : before_(GiNaC::Digits) { GiNaC::Digits = digits; }
  ~WorkingDigits() { GiNaC::Digits = before_; }
  WorkingDigits(const WorkingDigits&) = delete;
  WorkingDigits& operator=(const WorkingDigits&) = delete;

 private:
  long before_;
};

}  // namespace sinew
