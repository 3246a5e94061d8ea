# SPDX-License-Identifier: GPL-3.0-or-later
# Reads `objdump -dr --no-show-raw-insn`; prints every conditional or computed branch as
# "<function>: <instruction>". x86: every j but a plain jmp, loops, and jumps through a register or
# memory. Arm: b, bl, bx, pop and loads of pc under a condition, cbz, cbnz, tbb, tbh.
BEGIN { condition = "(eq|ne|cs|hs|cc|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)" }

/^[0-9a-f]+ <.*>:$/ {
  name = $2
  gsub(/[<>:]/, "", name)
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
  bad = 0
  if (operation ~ /^j/ && operation != "jmp") bad = 1
  if (operation ~ /^loop/) bad = 1
  if (operation == "jmp" && text ~ /\*/) bad = 1
  if (operation ~ ("^b(l|x|lx)?" condition "$")) bad = 1
  if (operation ~ /^(cbn?z|tbb|tbh)$/) bad = 1
  if (operation ~ ("^(pop|ldm(ia)?|ldr|mov)" condition "$") && text ~ /pc/) bad = 1
  if (bad) print name ": " text
}
