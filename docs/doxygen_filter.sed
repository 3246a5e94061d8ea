# SPDX-License-Identifier: GPL-3.0-or-later
# Comments as Doxygen takes them: <model> is a place to fill and no tag, @ and \ are no commands.
/^[[:space:]]*(\/\/|\*|\/\*)/ {
  s/\\/\\\\/g
  s/@/\\@/g
  s/<([A-Za-z\/])/\&lt;\1/g
}
# Behind code only what follows ///<.
:again
s/(\/\/\/<.*)<([A-Za-z\/])/\1\&lt;\2/
t again
