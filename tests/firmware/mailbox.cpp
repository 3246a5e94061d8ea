// SPDX-License-Identifier: GPL-3.0-or-later
// The mailbox between two sides, and the loop behind it.
#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "hand_loop.h"
#include "tests/firmware/hand_at.h"

using namespace sinew::test;

namespace {

struct Box {
  std::unique_ptr<mailbox> memory = std::make_unique<mailbox>();
  volatile mailbox& box() { return *memory; }
  Box() {
    std::memset(memory.get(), 0, sizeof(mailbox));
    memory->control.magic = MAILBOX_MAGIC;
    memory->control.layout = MAILBOX_LAYOUT;
  }
};

/// A hand at rest in the middle, lever counts alternating by one so that they live.
mailbox_measured frame_at_rest(std::uint32_t frame) {
  static const HandAt at = [] {
    std::array<double, HAND_TENDONS> counts;
    counts.fill(1700.0);
    return hand_at({}, {0.0, 0.0}, counts);
  }();
  mailbox_measured m;
  std::memset(&m, 0, sizeof m);
  m.frame = m.frame_again = frame;
  const hand_input in = input_of(at);
  for (int i = 0; i < HAND_TENDONS; ++i) {
    m.motor[i] = static_cast<std::int32_t>(
        std::lround(in.motor_angle[i] * static_cast<double>(MAILBOX_COUNTS_A_TURN) / 6.283185307));
    m.sensor[i] = static_cast<std::uint32_t>(in.lever_count[i] + frame % 2U) | MAILBOX_VALID;
  }
  for (int i = 0; i < 2; ++i)
    m.wrist[i] = static_cast<std::uint32_t>(in.wrist_count[i] + frame % 2U) | MAILBOX_VALID;
  return m;
}

/// A loop that has been given so many frames.
struct Loop {
  Box side;
  std::unique_ptr<hand_loop> loop = std::make_unique<hand_loop>();
  std::uint32_t frame = 0;
  Loop(int frames = 60) {
    side.memory->control.command = MAILBOX_DRIVE;
    REQUIRE(hand_loop_start(loop.get(), &side.box(), &hand_parameters_table) == HAND_LOOP_FINE);
    for (int i = 0; i < frames; ++i) give();
  }
  void give() {
    const mailbox_measured m = frame_at_rest(++frame);
    mailbox_write_measured(&side.box(), &m);
    REQUIRE(hand_loop_look(loop.get()) == MAILBOX_NEW);
    hand_loop_tick(loop.get(), 0);
  }
  mailbox_answer answer() {
    mailbox_answer a{};
    REQUIRE(mailbox_read_answer(&side.box(), &a) == 1);
    return a;
  }
};

}  // namespace

// Seen red with the comparison of both frames left out.
TEST_CASE("a reader sees new, repeated, skipped and torn frames", "[mailbox]") {
  Box side;
  mailbox_reader reader{};
  mailbox_measured got{};
  CHECK(mailbox_read_measured(&side.box(), &reader, &got) == MAILBOX_NOTHING);
  mailbox_measured m = frame_at_rest(7);
  mailbox_write_measured(&side.box(), &m);
  CHECK(mailbox_read_measured(&side.box(), &reader, &got) == MAILBOX_NEW);
  CHECK(got.frame == 7);
  CHECK(got.motor[3] == m.motor[3]);
  CHECK(mailbox_read_measured(&side.box(), &reader, &got) == MAILBOX_NOTHING);
  mailbox_write_measured(&side.box(), &m);
  CHECK(mailbox_read_measured(&side.box(), &reader, &got) == MAILBOX_REPEATED);
  m = frame_at_rest(10);
  mailbox_write_measured(&side.box(), &m);
  CHECK(mailbox_read_measured(&side.box(), &reader, &got) == MAILBOX_NEW);
  CHECK(reader.skipped == 2);
  // A writer that stopped in the middle: the sequence is odd.
  side.memory->measured.sequence += 1;
  CHECK(mailbox_read_measured(&side.box(), &reader, &got) == MAILBOX_NOTHING);
  // A writer without a lock: both ends are of different frames.
  side.memory->measured.sequence += 1;
  side.memory->measured.frame = 11;
  CHECK(mailbox_read_measured(&side.box(), &reader, &got) == MAILBOX_TORN);
  CHECK(got.frame == 10);
  CHECK((reader.repeated == 1 && reader.torn == 1));
  // The counter runs over.
  reader.frame = 0xffffffffU;
  m = frame_at_rest(0);
  mailbox_write_measured(&side.box(), &m);
  CHECK(mailbox_read_measured(&side.box(), &reader, &got) == MAILBOX_NEW);
}

// The setpoint has no frame at its end: the sequence word alone has to tell. Seen red with the
// comparison of the sequences after the copy left out of read_block.
TEST_CASE("no block that is taken is of two writings", "[mailbox]") {
  Box side;
  std::atomic<bool> stop{false};
  std::thread writer([&] {
    mailbox_setpoint s{};
    for (int number = 1; !stop; number = number % 1000000 + 1) {
      for (auto* values : {s.q, s.qd, s.qdd})
        std::fill(values, values + MAILBOX_COORDINATES, static_cast<float>(number));
      mailbox_write_setpoint(&side.box(), &s);
      if (number % 64 == 0) std::this_thread::yield();
    }
  });
  mailbox_setpoint got{};
  int taken = 0, mixed = 0;
  for (long tries = 0; taken < 3000000 && tries < 40000000; ++tries) {
    if (mailbox_read_setpoint(&side.box(), &got) == 0) continue;
    ++taken;
    for (const auto* values : {got.q, got.qd, got.qdd})
      for (int j = 0; j < MAILBOX_COORDINATES; ++j)
        mixed += values[j] < got.q[0] || values[j] > got.q[0];
  }
  stop = true;
  writer.join();
  CHECK(taken >= 1000);
  CHECK(mixed == 0);
}

TEST_CASE("the loop answers every frame and records it", "[mailbox]") {
  Loop loop;
  const mailbox_answer answer = loop.answer();
  CHECK(answer.frame == 60);
  CHECK(answer.heartbeat == 60);
  CHECK(answer.starts == 1);
  CHECK((answer.status & HAND_UNSAFE) == 0);
  CHECK(answer.torque[8] != 0);
  mailbox_record record{};
  std::uint32_t frames = 0;
  while (mailbox_take_record(&loop.side.box(), &record) == 1) CHECK(record.frame == ++frames);
  CHECK(frames == 60);
  CHECK(record.torque[8] == answer.torque[8]);
  CHECK(record.force[8] == Approx(loop.loop->output.force[8]));
  for (int i = 0; i < MAILBOX_RECORDS + 5; ++i) loop.give();
  CHECK(loop.answer().lost_records >= 4);
}

// Seen red with the input of the last frame used again in a late tick: the torques stayed.
TEST_CASE("without frames the torques hold, and become 0 after the stated time", "[mailbox]") {
  Loop loop;
  const std::uint32_t hold = hand_parameters_table.motor_limits.hold_ticks;
  for (std::uint32_t i = 1; i < hold; ++i) hand_loop_tick(loop.loop.get(), 1);
  CHECK(loop.answer().torque[8] != 0);
  hand_loop_tick(loop.loop.get(), 1);
  mailbox_answer answer = loop.answer();
  CHECK(answer.late == hold);
  for (const std::int32_t torque : answer.torque) CHECK(torque == 0);
  CHECK(answer.frame == 60);
  CHECK(answer.heartbeat == 60 + hold);
  // Frames come again: after the settling time the hand is driven again.
  for (int i = 0; i < 60; ++i) loop.give();
  answer = loop.answer();
  CHECK((answer.status & HAND_UNSAFE) == 0);
  CHECK(answer.torque[8] != 0);
}

TEST_CASE("a sensor word that is not valid counts as missing", "[mailbox]") {
  Loop loop;
  mailbox_measured m = frame_at_rest(++loop.frame);
  m.sensor[20] &= ~MAILBOX_VALID;
  mailbox_write_measured(&loop.side.box(), &m);
  REQUIRE(hand_loop_look(loop.loop.get()) == MAILBOX_NEW);
  hand_loop_tick(loop.loop.get(), 0);
  CHECK(loop.answer().channel_status[20] >> 16 == (SINEW_NOT_FINITE | SINEW_HELD));
  CHECK(loop.answer().channel_status[21] == 0);
}

TEST_CASE("a start without a mailbox, or with a damaged table, is refused", "[mailbox]") {
  Box side;
  const auto loop = std::make_unique<hand_loop>();
  side.memory->control.layout = MAILBOX_LAYOUT + 1;
  CHECK(hand_loop_start(loop.get(), &side.box(), &hand_parameters_table) == HAND_LOOP_LAYOUT);
  side.memory->control.layout = MAILBOX_LAYOUT;
  auto damaged = std::make_unique<hand_parameters>(hand_parameters_table);
  damaged->closure[5] += 1e-9;
  CHECK(hand_loop_start(loop.get(), &side.box(), damaged.get()) == HAND_LOOP_TABLE);
  CHECK(hand_loop_start(loop.get(), &side.box(), &hand_parameters_table) == HAND_LOOP_FINE);
  CHECK(hand_loop_start(loop.get(), &side.box(), &hand_parameters_table) == HAND_LOOP_FINE);
  CHECK(side.memory->answer.starts == 2);  // memory keeps it over a reset
}
