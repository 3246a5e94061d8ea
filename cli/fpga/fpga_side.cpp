// SPDX-License-Identifier: GPL-3.0-or-later
// fpga_side <model> <scenario> <memory file> <offset> <runtime> <log.csv>
//
// Plays the FPGA for a board, emulated or not, whose mailbox lies at an offset of a memory file:
// the simulated hand of a scenario gives the sensors' words, takes the torques, and waits for every
// answer before time goes on (lockstep). What the board's recorder kept is written as a log that
// sinew diagnose reads. At the end the board is told to stop.
// Status: 0; 1 where the board did not answer, skipped a frame or lost records; 2 wrong usage.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <thread>

#include "cli/terminal/terminal.h"
#include "firmware/mailbox.h"
#include "simulation/loop/hand_sensors.h"
#include "simulation/plant/write_rows.h"

namespace {

using namespace sinew;
using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds patience(60);  // emulated boards are slow

/// The mailbox in a memory file that an emulator shares.
class Memory {
 public:
  Memory(const std::string& file, long offset) {
    const int descriptor = ::open(file.c_str(), O_RDWR);
    if (descriptor < 0) throw std::runtime_error(file + ": cannot be opened");
    void* place = ::mmap(nullptr, sizeof(mailbox), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor,
                         static_cast<off_t>(offset));
    ::close(descriptor);
    if (place == MAP_FAILED) throw std::runtime_error(file + ": cannot be mapped");
    box_ = static_cast<volatile mailbox*>(place);
  }
  volatile mailbox& box() { return *box_; }

 private:
  volatile mailbox* box_;
};

/// The board's records as rows of a log.
class BoardLog {
 public:
  BoardLog(const std::string& file, const Plant& plant, double period)
      : period_(period), rows_(file, header(plant)) {}

  void drain(volatile mailbox& box) {
    mailbox_record r;
    while (mailbox_take_record(&box, &r) != 0) {
      values_ = {period_ * (r.frame - 1U)};
      for (const std::int32_t count : r.motor) values_.push_back(count / counts_a_radian);
      for (const std::int32_t torque : r.torque) values_.push_back(1e-6 * torque);
      values_.insert(values_.end(), r.force, r.force + MAILBOX_TENDONS);
      values_.insert(values_.end(), r.q, r.q + MAILBOX_COORDINATES);
      values_.insert(values_.end(), r.q_wrist, r.q_wrist + 2);
      rows_.write(values_);
      ++count_;
    }
  }
  void finish() { rows_.finish(); }
  long count() const { return count_; }

 private:
  static std::vector<std::string> header(const Plant& plant) {
    std::vector<std::string> names{"time [s]"};
    for (const char* format : {"theta_{} [rad]", "tau_{} [N·m]", "force_{} [N]"})
      for (int i = 1; i <= MAILBOX_TENDONS; ++i)
        names.push_back(fmt::format(fmt::runtime(format), i));
    for (const std::string& name : plant.joints()->names) names.push_back(name + " [rad]");
    names.insert(names.end(), {"q71 [rad]", "q73 [rad]"});
    return names;
  }

  double period_;
  RowWriter rows_;
  std::vector<double> values_;
  long count_ = 0;
};

mailbox_answer wait_for(volatile mailbox& box, std::uint32_t frame) {
  mailbox_answer answer;
  const auto start = Clock::now();
  for (long tries = 0;; ++tries) {
    if (mailbox_read_answer(&box, &answer) != 0 && answer.frame == frame && answer.heartbeat > 0)
      return answer;
    if (tries % 64 == 63) std::this_thread::yield();
    if (Clock::now() - start > patience)
      throw std::runtime_error(fmt::format("the board has not answered frame {}", frame));
  }
}

int run(char** words) {
  Memory memory(words[3], std::stol(words[4], nullptr, 0));
  Plant plant = build_plant(words[1], std::filesystem::path(words[2]), words[5]);
  HandSensors sensors(plant, hand_parameters_table);
  BoardLog log(words[6], plant, hand_parameters_table.period);
  volatile mailbox& box = memory.box();
  box.control.layout = MAILBOX_LAYOUT;
  box.control.command = MAILBOX_LOCKSTEP | MAILBOX_DRIVE;
  // Last: the board, which has a limit of time, is started when this is seen, and the plant's C may
  // take minutes to compile where others compile too.
  box.control.magic = MAILBOX_MAGIC;
  std::uint32_t frame = 0, status = 0;
  mailbox_answer answer{};
  double largest = 0.0;
  simulate(plant, [&](const std::vector<double>& row) {
    const mailbox_setpoint setpoint = sensors.setpoint(row.front());
    const mailbox_measured measured = sensors.measured(row, ++frame);
    mailbox_write_setpoint(&box, &setpoint);
    mailbox_write_measured(&box, &measured);
    answer = wait_for(box, frame);
    Eigen::VectorXd torque(MAILBOX_TENDONS);
    for (int i = 0; i < MAILBOX_TENDONS; ++i) torque(i) = 1e-6 * answer.torque[i];
    plant.hold_torque(torque);
    if (row.front() > 0.05) {
      status |= answer.status;
      for (int j = 0; j < MAILBOX_COORDINATES; ++j)
        largest = std::max(largest, std::abs(row[1 + static_cast<std::size_t>(j)] -
                                             static_cast<double>(setpoint.q[j])));
    }
    log.drain(box);
  });
  // The last tick's record comes after its answer.
  for (const auto start = Clock::now();
       log.count() < static_cast<long>(frame) && Clock::now() - start < patience;)
    log.drain(box);
  box.control.command = MAILBOX_LOCKSTEP | MAILBOX_STOP;
  log.finish();
  tell(
      "{} frames answered, {} recorded, status {:#x}, joints off by {:.4f} rad at most; torn {}, "
      "skipped {}, "
      "repeated {}, overruns {}, longest {}\n",
      frame, log.count(), status, largest, answer.torn, answer.skipped, answer.repeated,
      answer.overruns, answer.longest);
  return answer.skipped == 0 && log.count() == static_cast<long>(frame) ? 0 : 1;
}

}  // namespace

int main(int count, char** words) try {
  if (count != 7) {
    sinew::warn("usage: fpga_side <model> <scenario> <memory file> <offset> <runtime> <log.csv>\n");
    return 2;
  }
  return run(words);
} catch (const std::exception& error) {
  sinew::warn("fpga_side: {}\n", error.what());
  return 1;
}
