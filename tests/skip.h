// SPDX-License-Identifier: GPL-3.0-or-later
// A test that cannot be done here, wholly or in part, is skipped and never passed.
#pragma once

#include <string>

namespace sinew::test {

/// Counts the running test as skipped, and prints "skipped: <reason>". The caller returns where
/// nothing is left to check; what is checked before or after still fails the test.
void skip(const std::string& reason);

}  // namespace sinew::test
