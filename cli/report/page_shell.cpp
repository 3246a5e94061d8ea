// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/page_shell.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "generator/emit_javascript.h"
#include "generator/lower.h"
#include "generator/passes/pipeline.h"
#include "generator/reference.h"
#include "identification/report/page.h"

namespace sinew {
namespace {

using diagnosis::escaped;

/// Nodes of the longest function that a page takes along; beyond, it would be several megabytes.
constexpr Value longest_function = 30000;

std::string base64_hash(const std::string& text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> hash{};
  unsigned size = 0;
  if (EVP_Digest(text.data(), text.size(), hash.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("the page's script has no hash: OpenSSL has no SHA-256");
  std::array<unsigned char, 2 * EVP_MAX_MD_SIZE> base64{};
  const int length = EVP_EncodeBlock(base64.data(), hash.data(), static_cast<int>(size));
  return {base64.begin(), base64.begin() + length};
}

/// Inside a script element no "<" may stand that could end it.
std::string inside_script(std::string json) {
  std::string safe;
  for (const char c : json) safe += c == '<' ? "\\u003c" : std::string(1, c);
  return safe;
}

std::string program_of(const std::vector<Graph>& graphs) {
  std::string text = "\"use strict\";\n(() => {\n" + javascript_prelude() + "const functions = {\n";
  for (const Graph& graph : graphs)
    text += fmt::format("\"{}\": {},\n", graph.name, emit_javascript(graph));
  return text + "};\n" + page_program + "})();\n";
}

nlohmann::ordered_json ranges_json(const Port& port) {
  nlohmann::ordered_json ranges = nlohmann::ordered_json::array();
  for (const Range& range : port.ranges)
    ranges.push_back(nlohmann::ordered_json::array({range.low, range.high}));
  return ranges;
}

nlohmann::ordered_json ports_json(const Graph& graph) {
  nlohmann::ordered_json inputs = nlohmann::ordered_json::array(), outputs = inputs;
  for (const Port& port : graph.inputs)
    inputs.push_back({{"name", port.name},
                      {"unit", port.unit},
                      {"size", port.size()},
                      {"ranges", ranges_json(port)}});
  for (const Port& port : graph.outputs)
    outputs.push_back({{"name", port.name},
                       {"unit", port.unit},
                       {"doc", port.doc},
                       {"rows", port.rows},
                       {"cols", port.cols}});
  return {{"inputs", std::move(inputs)}, {"outputs", std::move(outputs)}};
}

nlohmann::ordered_json coordinates_json(const DrawnScene& drawing) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const DrawnCoordinate& c : drawing.coordinates)
    all.push_back({{"group", c.group},
                   {"label", c.label},
                   {"column", c.column},
                   {"unit", c.unit},
                   {"low", c.low},
                   {"high", c.high},
                   {"reference", c.reference}});
  return all;
}

/// The joint along which curves are drawn first: one in the middle of the chain bends the most.
std::size_t first_along(const DrawnScene& drawing) {
  return drawing.coordinates.size() > 2 ? drawing.coordinates.size() > 12 ? 6 : 2 : 0;
}

}  // namespace

std::string document(const std::string& title, const std::string& first, const std::string& rest,
                     const nlohmann::ordered_json& data, const std::vector<Graph>& graphs) {
  const std::string script = program_of(graphs);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'; script-src 'sha256-" +
         base64_hash(script) + "'\">\n<title>" + escaped(title) + "</title>\n<style>" +
         diagnosis::page_style() + page_sheet + "</style>\n</head>\n<body>\n<main>\n" + first +
         "<noscript><p class=\"note\">Without JavaScript this page has no drawing and no curves; "
         "its "
         "texts and tables are complete.</p></noscript>\n"
         "<script type=\"application/json\" id=\"data\">" +
         inside_script(data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)) +
         "</script>\n<script>" + script + "</script>\n" + rest + "</main>\n</body>\n</html>\n";
}

std::vector<Graph> functions_of_page(const ModelReport& report,
                                     std::vector<std::string>& left_out) {
  std::vector<Graph> graphs;
  for (const Graph& graph : report.emitted.functions)
    if (graph.size() <= longest_function)
      graphs.push_back(graph);
    else
      left_out.push_back(graph.name);
  if (report.drawing)
    for (const Function& function : report.drawing->functions)
      graphs.push_back(optimise(lower(function)));
  return graphs;
}

nlohmann::ordered_json data_of(const ModelReport& report, const std::vector<Graph>& graphs) {
  nlohmann::ordered_json data, functions = nlohmann::ordered_json::object(), reference = functions;
  for (const Graph& graph : graphs) {
    functions[graph.name] = ports_json(graph);
    for (const std::vector<double>& inputs : {reference_inputs(graph), beside_inputs(graph)})
      reference[graph.name].push_back(
          nlohmann::ordered_json::array({inputs, results_at(graph, Target{}, inputs)}));
  }
  data["functions"] = std::move(functions);
  data["reference"] = std::move(reference);
  data["scene"] = nullptr;
  data["coordinates"] = nlohmann::ordered_json::array();
  if (!report.drawing) return data;
  const DrawnScene& drawing = *report.drawing;
  data["scene"] = drawing.scene;
  data["coordinates"] = coordinates_json(drawing);
  data["view"] = {{"yaw", drawing.yaw}, {"pitch", drawing.pitch}, {"zoom", 1.0}};
  if (!drawing.palm.empty())
    data["palm"] = {
        {"at", drawing.palm}, {"inverse", "wrist_bar_angles"}, {"forward", "wrist_palm_angles"}};
  for (const auto& [key, name] :
       {std::pair("lengths", &report.lengths), std::pair("coupling", &report.coupling),
        std::pair("stiffness", &report.stiffness), std::pair("gravity", &report.gravity)})
    if (name->empty())
      data[key] = nullptr;
    else
      data[key] = *name;
  if (!report.weighed.torques.empty())
    data["weighed"] = {{"gravity", report.weighed.gravity},
                       {"torques", report.weighed.torques},
                       {"coordinates", report.weighed.coordinates}};
  data["held"] = report.held;
  data["free"] = report.free;
  data["along"] = first_along(drawing);
  return data;
}

std::string stage(const ModelReport& report, const std::string& controls) {
  const bool tendons = !report.coupling.empty();
  const std::string colours =
      tendons ? "<p class=\"forces\">Tendon force 0 <i></i> <span id=\"force-most\">–</span>; "
                "dashed: slack</p>\n"
              : "";
  return fmt::format(
      "<div class=\"stage{}\">\n<div class=\"card\">\n"
      "<svg id=\"drawing\" role=\"application\" tabindex=\"0\" aria-roledescription=\"drawing that "
      "turns\" aria-label=\"Drawing of {} in three dimensions: arrow keys turn it, plus and minus "
      "zoom, Home looks from the first side\"></svg>\n{}"
      "<p id=\"pointed\"></p>\n<div class=\"buttons\">"
      "<button id=\"view-first\" type=\"button\">First view</button>"
      "<button id=\"view-front\" type=\"button\">Along x</button>"
      "<button id=\"view-side\" type=\"button\">Along y</button>"
      "<button id=\"view-top\" type=\"button\">Along z</button>"
      "<button id=\"nearer\" type=\"button\" aria-label=\"Zoom in\">+</button>"
      "<button id=\"farther\" type=\"button\" aria-label=\"Zoom out\">−</button></div>\n</div>\n"
      "<div class=\"card\">\n{}</div>\n</div>\n",
      report.drawing && report.drawing->coordinates.size() > 10 ? " wide-controls" : "",
      escaped(report.emitted.name), colours, controls);
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string shown(double value) {
  const double size = std::abs(value);
  std::string text = size >= 1000.0 && size < 1e6 ? fmt::format("{:.0f}", value)
                                                  : fmt::format("{:.3g}", value),
              power;
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    constexpr std::array raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    power = "·10";
    for (const char c : std::to_string(std::stoi(text.substr(e + 1))))
      power += c == '-' ? "⁻" : raised[static_cast<std::size_t>(c - '0')];
    text = text.substr(0, e);
  }
  if (text.front() == '-') text.replace(0, 1, "−");
  return text + power;
}

}  // namespace sinew
