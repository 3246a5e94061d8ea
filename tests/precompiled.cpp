// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing but the headers that tests/CMakeLists.txt has precompiled for all rooms.
