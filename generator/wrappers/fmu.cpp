// SPDX-License-Identifier: GPL-3.0-or-later
// An FMI 3.0 co-simulation unit of the moving mechanism: the emitted forward dynamics integrated by
// Runge-Kutta steps, forces of tendons and torques of joints going in, motion coming out.
#include <fmt/format.h>

#include "generator/wrappers/fmu_source.h"
#include "generator/wrappers/moving_model.h"
#include "generator/wrappers/template_text.h"

namespace sinew {
namespace {

/// A run of variables, one for each joint or tendon.
struct FmuGroup {
  std::string macro, name, causality, variability, initial, unit, description;
  std::vector<std::string> elements;
  std::vector<double> start = {};
};

std::string effort_unit(const WrappedModel& model) {
  for (const WrappedJoint& joint : model.joints)
    if (joint.type != "revolute") return "";  // N m of some, N of others
  return "N.m";
}

std::vector<FmuGroup> groups(const WrappedModel& model) {
  std::vector<std::string> joints;
  std::vector<double> reference, damping;
  const std::vector<double> rest(model.joints.size(), 0.0), slack(model.tendons.size(), 0.0);
  for (const WrappedJoint& joint : model.joints) {
    joints.push_back(joint.name);
    reference.push_back(joint.reference);
    damping.push_back(joint.damping);
  }
  const std::string angle = effort_unit(model).empty() ? "" : "rad";
  const std::string rate = angle.empty() ? "" : "rad/s";
  const std::string effort = effort_unit(model);
  std::vector<FmuGroup> all{
      {"TENDON_FORCE", "tendon_force", "input", "continuous", "", "N",
       "Pulling force of the tendon", model.tendons, slack},
      {"JOINT_TORQUE", "joint_torque", "input", "continuous", "", effort,
       "Torque (force) on the joint besides the tendons'", joints, rest},
      {"Q_START", "q_start", "parameter", "fixed", "exact", angle, "Position at the start", joints,
       reference},
      {"QD_START", "qd_start", "parameter", "fixed", "exact", rate, "Velocity at the start", joints,
       rest},
      {"DAMPING", "damping", "parameter", "fixed", "exact", "", "Viscous damping of the joint",
       joints, damping},
      {"STEP",
       "integration_step",
       "parameter",
       "fixed",
       "exact",
       "s",
       "Longest step of the integration",
       {""},
       {1e-4}},
      {"Q", "q", "output", "continuous", "calculated", angle, "Position of the joint", joints},
      {"QD", "qd", "output", "continuous", "calculated", rate, "Velocity of the joint", joints},
      {"QDD", "qdd", "output", "continuous", "calculated", "", "Acceleration of the joint",
       joints}};
  if (has_function(model, "tendon_lengths", {"q"}))
    all.push_back({"TENDON_LENGTH", "tendon_length", "output", "continuous", "calculated", "m",
                   "Path length of the tendon", model.tendons});
  if (has_function(model, "forward_kinematics", {"q"}))
    all.push_back({"TIP",
                   "tip",
                   "output",
                   "continuous",
                   "calculated",
                   "m",
                   "Position of the tip in the base frame",
                   {"x", "y", "z"}});
  return all;
}

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += c;
  }
  return escaped;
}

std::string variable_xml(const FmuGroup& group, std::size_t element, int reference) {
  const std::string name =
      group.elements[element].empty() ? group.name : group.name + "." + group.elements[element];
  std::string text = fmt::format(
      "    <Float64 name=\"{}\" valueReference=\"{}\" causality=\"{}\" variability=\"{}\"", name,
      reference, group.causality, group.variability);
  if (!group.initial.empty()) text += fmt::format(" initial=\"{}\"", group.initial);
  if (!group.unit.empty()) text += fmt::format(" unit=\"{}\"", group.unit);
  if (!group.start.empty()) text += fmt::format(" start=\"{}\"", number_text(group.start[element]));
  return text + fmt::format(" description=\"{}\"/>\n", xml_text(group.description));
}

const char* const description_xml = R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: BSD-2-Clause
     Made by: sinew generate (fmu). Do not edit: change the model and generate again. -->
<fmiModelDescription fmiVersion="3.0" modelName="@MODEL@" instantiationToken="@HASH@"
    description="@TITLE@" generationTool="sinew" variableNamingConvention="structured">
  <CoSimulation modelIdentifier="sinew_@MODEL@_fmu" canHandleVariableCommunicationStepSize="true"
      canGetAndSetFMUState="true" maxOutputDerivativeOrder="0"/>
  <UnitDefinitions>
    <Unit name="rad"><BaseUnit rad="1"/></Unit>
    <Unit name="rad/s"><BaseUnit rad="1" s="-1"/></Unit>
    <Unit name="m"><BaseUnit m="1"/></Unit>
    <Unit name="N"><BaseUnit kg="1" m="1" s="-2"/></Unit>
    <Unit name="N.m"><BaseUnit kg="1" m="2" s="-2"/></Unit>
    <Unit name="s"><BaseUnit s="1"/></Unit>
  </UnitDefinitions>
  <DefaultExperiment startTime="0" stopTime="1" stepSize="0.001"/>
  <ModelVariables>
    <Float64 name="time" valueReference="0" causality="independent" variability="continuous" unit="s"/>
@VARIABLES@  </ModelVariables>
  <ModelStructure>
@STRUCTURE@  </ModelStructure>
</fmiModelDescription>
)";

const char* const build_xml = R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: BSD-2-Clause -->
<fmiBuildDescription fmiVersion="3.0">
  <BuildConfiguration modelIdentifier="sinew_@MODEL@_fmu">
    <SourceFileSet language="C99" compilerOptions="-ffp-contract=off -fno-math-errno -fno-tree-slp-vectorize">
      <SourceFile name="fmu.c"/>
      <SourceFile name="@MODEL@.c"/>
    </SourceFileSet>
  </BuildConfiguration>
</fmiBuildDescription>
)";

const char* const fmu_cmake = R"(# SPDX-License-Identifier: BSD-2-Clause
# Made by: sinew generate (--fmu). Builds @MODEL@.fmu in the build folder.
cmake_minimum_required(VERSION 3.16)
project(sinew_@MODEL@_fmu LANGUAGES C)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
string(TOLOWER "${CMAKE_SYSTEM_PROCESSOR}-${CMAKE_SYSTEM_NAME}" platform)  # as FMI names it
string(REPLACE "amd64" "x86_64" platform "${platform}")
set(unit ${CMAKE_CURRENT_BINARY_DIR}/unit)
add_library(sinew_@MODEL@_fmu MODULE sources/fmu.c sources/@MODEL@.c)
target_compile_options(sinew_@MODEL@_fmu PRIVATE -ffp-contract=off -fno-math-errno
                                                -fno-tree-slp-vectorize -fvisibility=hidden)
set_target_properties(sinew_@MODEL@_fmu PROPERTIES PREFIX "" C_STANDARD 11 POSITION_INDEPENDENT_CODE ON
  LIBRARY_OUTPUT_DIRECTORY ${unit}/binaries/${platform})
add_custom_command(OUTPUT @MODEL@.fmu VERBATIM DEPENDS sinew_@MODEL@_fmu modelDescription.xml
  COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/modelDescription.xml ${unit}
  COMMAND ${CMAKE_COMMAND} -E copy_directory ${CMAKE_CURRENT_SOURCE_DIR}/sources ${unit}/sources
  COMMAND ${CMAKE_COMMAND} -E chdir ${unit} ${CMAKE_COMMAND} -E tar cf ../@MODEL@.fmu --format=zip
          modelDescription.xml binaries sources)
add_custom_target(fmu ALL DEPENDS @MODEL@.fmu)
)";

/// fmu_model.h: where each group's values are, and which emitted functions there are.
std::string model_macros(const WrappedModel& model, const std::vector<FmuGroup>& all) {
  std::string text = filled(R"(/* SPDX-License-Identifier: BSD-2-Clause
 * Made by: sinew generate (--fmu). Do not edit: change the model and generate again. */
#ifndef FMU_MODEL_H
#define FMU_MODEL_H
#include "@MODEL@.h"
#define TOKEN "@HASH@"
#define FORWARD_DYNAMICS @MODEL@_forward_dynamics
)",
                            model);
  text += fmt::format("#define JOINTS {}\n#define TENDONS {}\n", model.joints.size(),
                      model.tendons.size());
  int reference = 1, first_output = 0;
  std::string starts;
  for (const FmuGroup& group : all) {
    if (!first_output && group.causality == "output") first_output = reference;
    text += fmt::format("#define {} {}\n", group.macro, reference);
    for (std::size_t i = 0; i < group.elements.size(); ++i)
      starts += fmt::format(" {},", group.start.empty() ? "0" : number_text(group.start[i]));
    reference += static_cast<int>(group.elements.size());
  }
  const auto offer = [&](const char* macro, const char* name, const std::vector<std::string>& in) {
    if (has_function(model, name, in))
      text += fmt::format("#define {} {}_{}\n", macro, model.name, name);
  };
  offer("TENDON_TORQUE", "joint_torque", {"q", "f"});
  offer("TENDON_LENGTHS", "tendon_lengths", {"q"});
  offer("TIP_POSE", "forward_kinematics", {"q"});
  return text + fmt::format(
                    "#define FIRST_OUTPUT {}\n#define VARIABLES {}\n/* value reference 0 is "
                    "the time */\n#define START_VALUES {{0,{}}}\n#endif\n",
                    first_output, reference, starts);
}

std::string model_description(const WrappedModel& model, const std::vector<FmuGroup>& all) {
  std::string variables, outputs, initial;
  int reference = 1;
  for (const FmuGroup& group : all)
    for (std::size_t i = 0; i < group.elements.size(); ++i, ++reference) {
      variables += variable_xml(group, i, reference);
      if (group.causality != "output") continue;
      outputs += fmt::format("    <Output valueReference=\"{}\"/>\n", reference);
      initial += fmt::format("    <InitialUnknown valueReference=\"{}\"/>\n", reference);
    }
  return filled(description_xml, model,
                {{"TITLE", xml_text(model.description)},
                 {"VARIABLES", variables},
                 {"STRUCTURE", outputs + initial}});
}

}  // namespace

FileSet fmu_files(const WrappedModel& model) {
  require_moving(model, "fmu");
  const std::vector<FmuGroup> all = groups(model);
  FileSet files{{"modelDescription.xml", model_description(model, all)},
                {"sources/buildDescription.xml", filled(build_xml, model)},
                {"sources/fmu_model.h", model_macros(model, all)},
                {"sources/fmu.c", fmu_source},
                {"CMakeLists.txt", filled(fmu_cmake, model)}};
  add_sources(files, model, "sources/", false);
  files.erase("sources/" + model.name + "_catalogue.c");
  files.erase("sources/" + model.name + "_catalogue.h");
  return files;
}

}  // namespace sinew
