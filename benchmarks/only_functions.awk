# SPDX-License-Identifier: GPL-3.0-or-later
# awk -v names="inverse_dynamics bias" -f only_functions.awk robot.c: emitted C with these functions
# only, so that sizes are those of one function and compiling takes seconds.
BEGIN { count = split(names, wanted, " ") }
/^void / {
  inside = 1
  kept = 0
  for (i = 1; i <= count; ++i) if (index($0, "_" wanted[i] "(") > 0) kept = 1
}
!inside || kept { print }
/^}/ { if (inside) kept = 0 }
