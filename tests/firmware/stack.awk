# SPDX-License-Identifier: GPL-3.0-or-later
# Reads the compiler's .su lines (first file), then `objdump -dr` of the same objects (second file):
# prints the deepest stack of every function, itself and what it calls, and a line starting with
# "finding" for recursion and for a stack above `limit` bytes (0: no limit).
# Copies of a function that the compiler specialised count as the function; of functions with one name
# in several files the largest frame counts.
function plain(text) {
  sub(/\.(isra|part|constprop|cold)(\.[0-9]+)?$/, "", text)
  return text
}

FNR == NR {
  split($0, field, "\t")
  parts = split(field[1], place, ":")
  name = plain(place[parts])
  if (field[2] + 0 > frame[name]) frame[name] = field[2] + 0
  next
}

/^[0-9a-f]+ <.*>:$/ {
  settle()
  name = $2
  gsub(/[<>:]/, "", name)
  name = plain(name)
  order[++count] = name
  next
}

# A target in the same section is shown in the instruction; any other in a relocation below it, and
# what the instruction shows is then none.
/R_X86_64_(PLT32|PC32)|R_ARM_(THM_)?(CALL|JUMP24|PC24)/ {
  callee = $NF
  sub(/-0x[0-9a-f]+$/, "", callee)
  calls[name, plain(callee)] = 1
  shown = ""
  next
}
{ settle() }
# A jump of a function to its own start is a loop.
/\t(jmp|jmpq|b|b\.w|b\.n)[ \t]/ && index($0, "<" name ">") { next }
/\t(call|callq|jmp|jmpq|bl|b|b\.w|b\.n)[ \t].*<[^+>]*>/ {
  shown = $0
  sub(/.*</, "", shown)
  sub(/>.*/, "", shown)
}

function settle() {
  if (shown != "") calls[name, plain(shown)] = 1
  shown = ""
}

# Depth first; `open` marks the functions on the path.
function deepest(caller, key, pair, below, most) {
  if (caller in open) {
    print "finding " caller ": recursion"
    return 0
  }
  open[caller] = 1
  most = 0
  for (key in calls) {
    split(key, pair, SUBSEP)
    if (pair[1] == caller && pair[2] in frame) {
      below = deepest(pair[2])
      if (below > most) most = below
    }
  }
  delete open[caller]
  return frame[caller] + most
}

END {
  settle()
  for (i = 1; i <= count; ++i) {
    bytes = deepest(order[i])
    printf "%6d bytes of stack: %s\n", bytes, order[i]
    if (limit > 0 && bytes > limit) {
      print "finding " order[i] ": " bytes " bytes; expected at most " limit
    }
  }
}
