# SPDX-License-Identifier: GPL-3.0-or-later
# awk -f test_results.awk <JUnit file of CTest>...: prints "<passed> <failed> <skipped>", then a line
# "<test>: <reason>" for each skipped test, then "not run: <test>: <why>" for each that failed by not
# being run. A skipped test is one that said so itself, with its reason in a line "skipped: <reason>";
# what CTest could not start, or skipped without a reason, has failed.
function plain(text) {
  gsub(/&lt;/, "<", text)
  gsub(/&gt;/, ">", text)
  gsub(/&quot;/, "\"", text)
  gsub(/&apos;/, "'", text)
  gsub(/&amp;/, "\\&", text)
  return text
}
function attribute(name) {
  if (!match($0, " " name "=\"[^\"]*\"")) return ""
  return plain(substr($0, RSTART + length(name) + 3, RLENGTH - length(name) - 4))
}

/^\t<testcase / {
  test = attribute("name")
  status = attribute("status")
  why = status
  reason = ""
  asked = 0
}
/^\t\t<skipped / {
  why = attribute("message")
  asked = why ~ /^SKIP_/
}
/^(\t\t<system-out>)?skipped: / && reason == "" {
  reason = $0
  sub(/^(\t\t<system-out>)?skipped: /, "", reason)
  sub(/<\/system-out>$/, "", reason)
  reason = plain(reason)
}
/^\t<\/testcase>/ {
  if (status == "run") {
    passed++
  } else if (asked && reason != "") {
    told[++skipped] = test ": " reason
  } else {
    failed++
    if (status != "fail") left[++unstarted] = "not run: " test ": " why
  }
}
END {
  print passed + 0, failed + 0, skipped + 0
  for (i = 1; i <= skipped; i++) print told[i]
  for (i = 1; i <= unstarted; i++) print left[i]
}
