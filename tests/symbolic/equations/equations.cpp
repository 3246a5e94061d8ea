// SPDX-License-Identifier: GPL-3.0-or-later
// Equations for people say what is computed: with the table's values put in they give the numbers
// that independent code gives.
#include "symbolic/equations/equations.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/parts/part.h"
#include "symbolic/tendons/tendon_functions.h"
#include "tests/reference/newton_euler.h"

using namespace sinew;

namespace {

const std::filesystem::path source = SINEW_SOURCE_DIR;

void symbols_in(const GiNaC::ex& e, std::map<std::string, GiNaC::ex>& found) {
  if (GiNaC::is_a<GiNaC::symbol>(e)) found[GiNaC::ex_to<GiNaC::symbol>(e).get_name()] = e;
  for (const GiNaC::ex& operand : e) symbols_in(operand, found);
}

using Values = std::map<std::string, double>;

/// Works through a page as a reader would: every symbol is an argument, in the table or defined
/// before. Throws std::out_of_range with the name of one that is not.
Values worked_through(const EquationPage& page, const Values& arguments) {
  Values values = arguments;
  for (const EquationSymbol& symbol : page.symbols)
    if (symbol.value) values[symbol.name] = *symbol.value;
  for (const EquationSection& section : page.sections)
    for (const ReadableEquation& equation : section.equations) {
      std::map<std::string, GiNaC::ex> used;
      symbols_in(equation.right, used);
      GiNaC::exmap map;
      for (const auto& [name, symbol] : used) {
        if (!values.contains(name)) throw std::out_of_range(name + " in " + equation.left);
        map[symbol] = values.at(name);
      }
      values[equation.left] =
          GiNaC::ex_to<GiNaC::numeric>(equation.right.subs(map).evalf()).to_double();
    }
  return values;
}

struct Case {
  const char* model;
  std::vector<std::pair<const char*, double>> q, qd;
};

const std::vector<Case> cases{{"index",
                               {{"q_20", 0.1}, {"q_21", 0.7}, {"q_22", 0.9}, {"q_23", 0.4}},
                               {{"qd_20", 1.1}, {"qd_21", -0.7}, {"qd_22", 0.9}, {"qd_23", 2.0}}},
                              {"thumb",
                               {{"q_10", 0.2}, {"q_11", -0.3}, {"q_12", 0.9}, {"q_13", 0.4}},
                               {{"qd_10", 1.1}, {"qd_11", -0.7}, {"qd_12", 0.9}, {"qd_13", 2.0}}}};

/// Largest difference of M and P from independent numerics, relative to the largest entries.
double deviation(const Mechanism& mechanism, const EquationPage& page, const Case& c) {
  Values arguments(c.q.begin(), c.q.end());
  arguments.insert(c.qd.begin(), c.qd.end());
  const Values values = worked_through(page, arguments);
  Eigen::VectorXd q(4), qd(4);
  std::vector<double> inputs;
  for (Eigen::Index k = 0; k < 4; ++k) {
    q[k] = c.q[static_cast<std::size_t>(k)].second;
    qd[k] = c.qd[static_cast<std::size_t>(k)].second;
    inputs.push_back(q[k]);
  }
  const Eigen::MatrixXd M = reference::NewtonEuler<double>(mechanism).mass_matrix(q);
  double worst = 0.0;
  for (int j = 0; j < 4; ++j)
    for (int k = j; k < 4; ++k)
      worst = std::max(
          worst,
          std::abs(values.at("M_" + std::to_string(j + 1) + std::to_string(k + 1)) - M(j, k)) /
              M.cwiseAbs().maxCoeff());
  std::vector<double> P;
  for (const Function& function : tendon_functions(mechanism))
    if (function.name == "coupling_matrix") P = evaluate(function, inputs);
  for (std::size_t i = 0; i < P.size(); ++i) {
    const std::string name =
        "P_" + mechanism.tendons[i / 4].name + "_" + std::string(c.q[i % 4].first).substr(2);
    const auto listed = values.find(name);  // what is 0 is not listed
    worst =
        std::max(worst, std::abs((listed == values.end() ? 0.0 : listed->second) - P[i]) / 0.01);
  }
  // T = L + V: kinetic energy where there is no gravity.
  Values still = arguments;
  for (const auto& [name, rate] : c.qd) still[name] = 0.0;
  const double T = values.at("L") - worked_through(page, still).at("L");
  return std::max(worst, std::abs(T - 0.5 * qd.dot(M * qd)) / T);
}

/// Whether every tag is closed by its own.
bool well_formed(const std::string& text) {
  static const std::regex tag("<(/?)([a-zA-Z0-9]+)[^>]*?(/?)>");
  std::vector<std::string> open;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), tag); at != std::sregex_iterator();
       ++at) {
    const std::string name = (*at)[2];
    if (name == "meta" || (*at)[3].length() > 0) continue;
    if ((*at)[1].length() == 0) {
      open.push_back(name);
    } else {
      if (open.empty() || open.back() != name) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

bool balanced(const std::string& latex) {
  int depth = 0;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    if (i > 0 && latex[i - 1] == '\\') continue;
    depth += latex[i] == '{' ? 1 : latex[i] == '}' ? -1 : 0;
    if (depth < 0) return false;
  }
  return depth == 0;
}

}  // namespace

TEST_CASE("the equations of a finger give its mass matrix, coupling matrix and energy",
          "[equations]") {
  for (const Case& c : cases) {
    const Mechanism mechanism = read_mechanism(source / "models" / c.model);
    EquationPage page = mechanism_equations(mechanism);
    CHECK(deviation(mechanism, page, c) < 1e-12);
    // Planted: a mass, a length and the size of a pulley that the table says wrongly.
    for (EquationSymbol& symbol : page.symbols) {
      if (!symbol.value || (symbol.name != "m_proximal" && symbol.name != "l_22_x" &&
                            symbol.name != "l_13_x" && symbol.name != "r_22"))
        continue;
      const double right = *symbol.value;
      symbol.value = 1.01 * right;
      CHECK(deviation(mechanism, page, c) > 1e-6);
      symbol.value = right;
    }
  }
}

TEST_CASE("coupled joints keep their ratio as a symbol", "[equations]") {
  const EquationPage page = mechanism_equations(read_mechanism(source / "models/ring"));
  const std::string text = printed(page, EquationFormat::text);
  CHECK(text.find("rho_") != std::string::npos);
  CHECK_NOTHROW(worked_through(page, {{"q_40", 0.1},
                                      {"q_41", 0.2},
                                      {"q_42", 0.3},
                                      {"qd_40", 1},
                                      {"qd_41", 1},
                                      {"qd_42", 1},
                                      {"q_30", 0.1},
                                      {"q_31", 0.2},
                                      {"q_32", 0.3},
                                      {"qd_30", 1},
                                      {"qd_31", 1},
                                      {"qd_32", 1}}));
}

TEST_CASE("the equations of the wrist give its pose", "[equations]") {
  const Part part = read_part(source / "models/wrist");
  const auto& wrist = std::get<WristParameters>(part.parameters);
  const double q71 = 0.6, q73 = 1.0;
  Values arguments{{"q_71", q71}, {"q_73", q73}};
  const Eigen::Vector3d F = wrist.forearm_points[4], P = wrist.palm_points[4];
  for (int k = 0; k < 3; ++k) {
    arguments[std::string("F_") + "xyz"[k]] = F[k];
    arguments[std::string("P_") + "xyz"[k]] = P[k];
  }
  const Values values = worked_through(wrist_equations(wrist), arguments);
  const double expected = evaluate(wrist_tendon_lengths(wrist), {q71, q73})[4];
  CHECK(std::abs(values.at("h") - expected) < 1e-12);
}

TEST_CASE("equations are printed whole in every format", "[equations]") {
  const Part part = read_part(source / "models/wrist");
  const EquationPage pages[] = {mechanism_equations(read_mechanism(source / "models/index")),
                                mechanism_equations(read_mechanism(source / "models/thumb")),
                                wrist_equations(std::get<WristParameters>(part.parameters)),
                                effect_equations()};
  for (const EquationPage& page : pages) {
    const std::string latex = printed(page, EquationFormat::latex);
    CHECK(balanced(latex));
    CHECK(latex.find("\\begin{align*}") != std::string::npos);
    CHECK(latex.find("\\text{?}") == std::string::npos);
    const std::string html = printed(page, EquationFormat::mathml);
    CHECK(well_formed(html));
    CHECK(html.find("<mtext>?</mtext>") == std::string::npos);
    for (const EquationSection& section : page.sections)
      CHECK(latex.find(section.source) != std::string::npos);
  }
  // Planted.
  CHECK_FALSE(balanced("\\frac{a}{b"));
  CHECK_FALSE(well_formed("<math><mi>a</math></mi>"));
}
