# SPDX-License-Identifier: GPL-3.0-or-later
# Compares firmware/budget.csv (first file) with rows of one model on one board as board_budget prints
# them (second file). A finding is a function that is not in the table, one of the table that is not
# emitted any more, and a value that grew by more than 2 %; what shrank by as much is only told.
# Status 1 where there is a finding, or nothing was measured.
BEGIN {
  FS = ","
  split(",,instructions,bytes,bytes of ram,bytes of stack", kind, ",")
}

FNR == NR {
  accepted[$1, $2] = $0
  model[$1, $2] = $7
  next
}

{
  ++measured
  board = $1
  own = $7
  seen[$1, $2] = 1
  if (!(($1, $2) in accepted)) {
    print "finding: " $2 ": not in the table"
    bad = 1
    next
  }
  split(accepted[$1, $2], was, ",")
  for (i = 3; i <= 6; ++i) {
    if ($i == was[i]) continue
    print ($i > 1.02 * was[i] ? "finding: " : "") $2 ": " was[i] " -> " $i " " kind[i]
    if ($i > 1.02 * was[i]) bad = 1
  }
}

END {
  for (row in accepted) {
    split(row, part, SUBSEP)
    if (part[1] == board && model[row] == own && !(row in seen)) {
      print "finding: " part[2] ": in the table, but not emitted"
      bad = 1
    }
  }
  exit bad || measured == 0
}
