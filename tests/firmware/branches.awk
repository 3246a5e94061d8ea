# SPDX-License-Identifier: GPL-3.0-or-later
# Reads `objdump -dr --no-show-raw-insn`; prints every conditional or computed branch as
# "<function>: <instruction>". x86: every j but a plain jmp, loops, and jumps through a register or
# memory. Arm: b, bl, bx, pop and loads of pc under a condition, cbz, cbnz, tbb, tbh.
# The end of a loop is none of them: a branch back that an integer comparison decides. That the number
# of passes is fixed is what the instruction counts show.
BEGIN { condition = "(eq|ne|cs|hs|cc|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)" }

# The value of a hexadecimal number.
function value(digits, i, sum) {
  sum = 0
  for (i = 1; i <= length(digits); ++i)
    sum = 16 * sum + index("0123456789abcdef", substr(digits, i, 1)) - 1
  return sum
}

# "bne.n<tab>12 <f+0x12>" at address "1a:" leads back.
function leads_back(text, line, own, target) {
  own = line
  sub(/^ */, "", own)
  sub(/:.*/, "", own)
  target = text
  sub(/^[a-z.,]+[ \t]+/, "", target)
  if (target !~ /^[0-9a-f]+ </) return 0
  sub(/ .*/, "", target)
  return value(target) < value(own)
}

/^[0-9a-f]+ <.*>:$/ {
  name = $2
  gsub(/[<>:]/, "", name)
  compared = ""
  next
}

/^ *[0-9a-f]+:\t/ {
  text = $0
  sub(/^ *[0-9a-f]+:\t/, "", text)
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
  if (operation ~ /^(cmp|test|sub|add|dec|inc)[bwlq]?$|^(cmn|tst|teq|subs|adds)$/) compared = "integer"
  bad = 0
  if (operation ~ /^j/ && operation != "jmp") bad = 1
  if (operation ~ /^loop/) bad = 1
  if (operation == "jmp" && text ~ /\*/) bad = 1
  if (operation ~ ("^b(l|x|lx)?" condition "$")) bad = 1
  if (operation ~ /^(cbn?z|tbb|tbh)$/) bad = 1
  if (operation ~ ("^(pop|ldm(ia)?|ldr|mov)" condition "$") && text ~ /pc/) bad = 1
  if (bad && compared == "integer" && leads_back(text, $0)) bad = 0
  if (bad) print name ": " text
}
