# SPDX-License-Identifier: GPL-3.0-or-later
# Reads `objdump -dr --no-show-raw-insn`; prints every conditional or computed branch as
# "<function>: <instruction>". x86: every j but a plain jmp, loops, and jumps through a register or
# memory. Arm: b, bl, bx, pop and loads of pc under a condition, cbz, cbnz, tbb, tbh.
# The end of a loop is none of them: a branch back that an integer comparison decides; or, where a
# compiler puts it amid the loop, one out of it that the comparison with a constant decides. That the
# number of passes is fixed is what the instruction counts show.
BEGIN { condition = "(eq|ne|cs|hs|cc|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)" }

# The value of a hexadecimal number.
function value(digits, i, sum) {
  sum = 0
  for (i = 1; i <= length(digits); ++i)
    sum = 16 * sum + index("0123456789abcdef", substr(digits, i, 1)) - 1
  return sum
}

# Where "bne.n<tab>12 <f+0x12>" leads; -1 where that is in a register.
function target_of(text) {
  sub(/^[a-z.,]+[ \t]+/, "", text)
  if (text !~ /^[0-9a-f]+ </) return -1
  sub(/ .*/, "", text)
  return value(text)
}

# Whether a branch forward leaves a loop: before its target a jump leads back over it, and nothing
# after that leads into the loop again.
function leaves_loop(own, target, head, from) {
  if (!(target in jump_before)) return 0
  head = jump_before[target]
  if (head < 0 || head > own) return 0
  for (from in leads_to)
    if (from + 0 >= target && leads_to[from] >= head && leads_to[from] < target) return 0
  return 1
}

# What of a function waited for its end.
function finish(i) {
  for (i = 1; i <= waiting; ++i)
    if (!leaves_loop(waiting_at[i], waiting_for[i])) print name ": " waiting_text[i]
  waiting = 0
  last_jump = -1
  split("", jump_before)
  split("", leads_to)
}

/^[0-9a-f]+ <.*>:$/ {
  finish()
  name = $2
  gsub(/[<>:]/, "", name)
  compared = ""
  next
}

/^ *[0-9a-f]+:\t/ {
  text = own = $0
  sub(/^ *[0-9a-f]+:\t/, "", text)
  gsub(/^ *|:.*/, "", own)
  own = value(own)
  jump_before[own] = last_jump
  operation = text
  sub(/[ \t].*/, "", operation)
  if (operation == "notrack" || operation == "bnd") {
    sub(/^[a-z]+ /, "", text)
    operation = text
    sub(/[ \t].*/, "", operation)
  }
  sub(/\.[nw]$/, "", operation)
  # What set the flags last: x86's comparisons and arithmetic, Arm's and what ends in s.
  if (operation ~ /^(v?u?comis[sd]|vmrs)$/) compared = "real"
  if (operation ~ /^(cmp|test|sub|add|dec|inc)[bwlq]?$|^(cmn|tst|teq|subs|adds)$/)
    compared = text ~ /^cmp[a-z.]*[ \t]+(\$|[a-z0-9]+, #)/ ? "constant" : "integer"
  target = target_of(text)
  if (operation ~ ("^(j.*|b|b" condition ")$")) leads_to[own] = target
  last_jump = operation ~ /^(jmp|b)$/ ? target : -1
  bad = 0
  if (operation ~ /^j/ && operation != "jmp") bad = 1
  if (operation ~ /^loop/) bad = 1
  if (operation == "jmp" && text ~ /\*/) bad = 1
  if (operation ~ ("^b(l|x|lx)?" condition "$")) bad = 1
  if (operation ~ /^(cbn?z|tbb|tbh)$/) bad = 1
  if (operation ~ ("^(pop|ldm(ia)?|ldr|mov)" condition "$") && text ~ /pc/) bad = 1
  if (bad && compared ~ /integer|constant/ && target >= 0 && target < own) bad = 0
  if (bad && compared == "constant" && target > own) {
    waiting_at[++waiting] = own
    waiting_for[waiting] = target
    waiting_text[waiting] = text
    bad = 0
  }
  if (bad) print name ": " text
}

END { finish() }
