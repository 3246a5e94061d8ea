/* SPDX-License-Identifier: GPL-3.0-or-later
 * What cppcheck's MISRA addon has to find: a goto (15.1) and a recursion (17.2). */
int planted(int n);

int planted(int n) {
  if (n > 0) {
    goto end;
  }
  return planted(n + 1);
end:
  return n;
}
