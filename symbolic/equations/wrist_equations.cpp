// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/equations/equations.h"
#include "symbolic/expressions/definition_list.h"
#include "symbolic/parts/wrist_geometry.h"

namespace sinew {
namespace {

using GiNaC::ex;

struct WristSymbols {
  GiNaC::symbol a{"a"}, b{"b"}, c{"c"}, r{"r"}, margin{"epsilon"}, q71{"q_71"}, q73{"q_73"};
};

EquationSection section_of(const std::string& title, const std::string& source,
                           const std::string& text, const DefinitionList& list, std::size_t& told) {
  EquationSection section{title, source, text, {}};
  for (; told < list.items().size(); ++told)
    section.equations.push_back({list.items()[told].symbol.get_name(), list.items()[told].value});
  return section;
}

/// A point given by symbols, in the order in which the page tells of them.
Vector3 symbols_of(const std::string& name) {
  return {GiNaC::symbol(name + "_x"), GiNaC::symbol(name + "_y"), GiNaC::symbol(name + "_z")};
}

void add_symbols(EquationPage& page, const WristParameters& p) {
  const WristLinks links(p);
  const auto number = [](const GiNaC::numeric& value) { return value.to_double(); };
  page.symbols = {
      {"q_71", "turns the bar plane about y", std::nullopt, "rad", ""},
      {"q_73", "swings the bars within their plane", std::nullopt, "rad", ""},
      {"a", "length of the wrist (Table 6.1)", p.length, "m", "[wrist] length"},
      {"b", "width (Table 6.1)", p.width, "m", "[wrist] width"},
      {"c", "thickness (Table 6.1)", p.thickness, "m", "[wrist] thickness"},
      {"r", "length of the bars B0B and C0C: r^2 = a^2 + b^2 + c^2", number(links.r), "m",
       "follows from a, b, c"},
      {"epsilon", "nearer than this to a singular pose counts as in it", p.singular_margin, "rad",
       "the program's"},
      {"F_x", "point of a tendon in the forearm frame, and y, z", std::nullopt, "m",
       "[[channel]] forearm"},
      {"P_x", "its point in the palm frame, and y, z", std::nullopt, "m", "[[channel]] palm"}};
}

}  // namespace

EquationPage wrist_equations(const WristParameters& parameters) {
  const WristSymbols s;
  EquationPage page;
  page.title = "Equations of the wrist";
  DefinitionList list;
  std::size_t told = 0;
  BarAngles angles;
  angles.cos_q71 = list.define("c_71", GiNaC::cos(s.q71));
  angles.sin_q71 = list.define("s_71", GiNaC::sin(s.q71));
  angles.cos_q73 = list.define("c_73", GiNaC::cos(s.q73));
  angles.sin_q73 = list.define("s_73", GiNaC::sin(s.q73));
  const WristLengths lengths{s.a, s.b, s.c, s.r, s.r * s.r, s.margin};
  const WristPose pose = wrist_pose(list, lengths, angles);
  page.sections.push_back(section_of(
      "Pose of the palm in closed form", "(6.1) to (6.8)",
      "Bars B0-B-C-C0 in the bar plane (along e and y), the plane BCM, the point A, and the axes "
      "x, y, z and the origin of the palm frame {ABC} in the forearm frame {0}. In a singular pose "
      "the maxima and limits continue the solution.",
      list, told));
  const Vector3 F = symbols_of("F"), P = symbols_of("P");
  const Vector3 at = pose.origin + P[0] * pose.x + P[1] * pose.y + P[2] * pose.z;
  const Vector3 d = define(list, "d", F - at);
  EquationSection tendon =
      section_of("Length of a tendon", "(6.9)",
                 "From its point F in the forearm to its point P in the palm.", list, told);
  tendon.equations.push_back({"h", GiNaC::sqrt(dot(d, d))});
  page.sections.push_back(std::move(tendon));
  add_symbols(page, parameters);
  return page;
}

}  // namespace sinew
