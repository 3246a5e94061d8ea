// SPDX-License-Identifier: GPL-3.0-or-later
// sinew_trials: draws one sealed trial, or prints what is offered. It is linked to nothing of the
// program under test.
#include <fmt/core.h>

#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "tests/blind/truth/draw_trial.h"
#include "tests/blind/truth/limits.h"

namespace {

using namespace sinew::trials;

constexpr const char* usage =
    "usage: sinew_trials draw --plant <plant> --family <family> --size <noise's> --seed <n> "
    "--folder "
    "<folder> [--cause <cause>] [--logs <for training>]\n"
    "           writes model, channels and logs into the folder, the seal to standard output\n"
    "       sinew_trials play <the same> --motion <planned motion> --out <log>\n"
    "           plays a planned motion on the plant of that trial\n"
    "       sinew_trials offers --plant <plant> --seed <n>\n"
    "       sinew_trials limits\n";

int offers(const TrialRequest& request) {
  const auto plant = draw_plant(request, sinew::truth::Draw(request.seed).fork());
  auto list = nlohmann::json::array();
  for (const Offer& o : plant->offers())
    list.push_back(
        {{"cause", o.cause}, {"place", o.place}, {"order", o.order}, {"outside", o.outside}});
  fmt::print("{}\n", list.dump());
  return 0;
}

int run(int count, char** words) {
  if (count < 2) throw std::invalid_argument("a command is missing");
  const std::string command = words[1];
  std::map<std::string, std::string> option;
  for (int i = 2; i + 1 < count; i += 2) option[words[i]] = words[i + 1];
  if (count % 2 != 0) throw std::invalid_argument("an option lacks its value");
  const auto take = [&](const char* name, const std::string& otherwise) {
    const auto at = option.find(name);
    if (at == option.end()) return otherwise;
    std::string value = at->second;
    option.erase(at);
    return value;
  };
  TrialRequest request;
  request.plant = take("--plant", request.plant);
  request.family = take("--family", request.family);
  request.cause = take("--cause", "");
  request.size = std::stod(take("--size", "1"));
  request.logs = std::stoi(take("--logs", "1"));
  request.seed = std::stoull(take("--seed", "1"));
  const std::string folder = take("--folder", "");
  const std::string motion = take("--motion", ""), out = take("--out", "");
  if (!option.empty()) throw std::invalid_argument("no option is called " + option.begin()->first);
  if (command == "limits") {
    fmt::print("{}", limits_text());
    return 0;
  }
  if (command == "offers") return offers(request);
  if (command == "play" && !motion.empty() && !out.empty()) {
    play_motion(request, motion, out);
    return 0;
  }
  if (command != "draw" || folder.empty())
    throw std::invalid_argument(
        "draw needs a --folder, play a --motion and --out; commands are draw, play, offers, "
        "limits");
  fmt::print("{}\n", draw_trial(request, folder));
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    return run(count, words);
  } catch (const std::exception& error) {
    fmt::print(stderr, "sinew_trials: {}\n{}", error.what(), usage);
    return 2;
  }
}
