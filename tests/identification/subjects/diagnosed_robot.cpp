// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/subjects/diagnosed_robot.h"

#include "identification/adoption/diagnose.h"
#include "identification/subjects/driven_channels.h"
#include "symbolic/extension/driven_model.h"
#include "tests/reference/temporary_folder.h"

namespace sinew::test {

Mechanism slide(double mass, double damping, double friction) {
  Mechanism m;
  m.name = "slide";
  Body body;
  body.name = "carriage";
  body.mass = mass;
  Joint joint;
  joint.name = "x";
  joint.type = JointType::prismatic;
  joint.damping = damping;
  joint.friction = friction;
  m.bodies = {body};
  m.joints = {joint};
  m.gravity.setZero();
  return m;
}

diagnosis::Findings diagnosed(const Mechanism& nominal, const std::string& train,
                              const std::string& holdout) {
  return whole_diagnosis(nominal, train, holdout).findings;
}

diagnosis::Diagnosis whole_diagnosis(const Mechanism& nominal, const std::string& train,
                                     const std::string& holdout) {
  return diagnosis_of(nominal, {{"train.csv", train, false}, {"holdout.csv", holdout, true}});
}

diagnosis::Diagnosis diagnosis_of(const Mechanism& nominal, const std::vector<LogText>& logs,
                                  const std::vector<std::string>& conditions) {
  const reference::TemporaryFolder folder;
  diagnosis::DiagnoseRequest request;
  request.model = driven_model(nominal);
  request.mechanism = nominal;
  request.name = nominal.name;
  request.runtime = SINEW_SOURCE_DIR "/runtime";
  for (const LogText& log : logs) {
    reference::write_text(folder.path() / log.name, log.text);
    (log.held_out ? request.holdout : request.logs).push_back((folder.path() / log.name).string());
  }
  for (const std::string& text : conditions) request.payloads.push_back(carried_payload(text));
  request.channels = [&](const std::string& log) {
    return diagnosis::robot_log_channels(nominal, log, {});
  };
  request.settings.edge_s = diagnosis::driven_edge;
  request.settings.band_hz = diagnosis::driven_band;
  return diagnosis::diagnose(request);
}

}  // namespace sinew::test
