// SPDX-License-Identifier: GPL-3.0-or-later
// The runtime's parts beside the trigonometry. Planted defects that were seen red: see each test.
#include <catch2/catch.hpp>

#include <Eigen/Cholesky>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <thread>

#include "sinew_runtime.h"

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

sinew_channel_limits limits() {
  sinew_channel_limits l{};
  l.low = -10.0;
  l.high = 10.0;
  l.largest_step = 1.0;
  l.safe = -3.0;
  l.hold_ticks = 4;
  l.frozen_ticks = 5;
  l.settle_ticks = 3;
  return l;
}

struct Channel {
  sinew_channel_limits l = limits();
  sinew_channel state{};
  double value = 0.0;
  explicit Channel(double first = 0.0) {
    sinew_channel_start(&state, &l);
    for (int i = 0; i < 5; ++i) tick(first + 0.01 * i);
  }
  std::uint32_t tick(double sample) {
    value = sinew_channel_tick(&state, &l, sample);
    CHECK(sinew_channel_value(&state, &l) == value);
    return state.status;
  }
};

}  // namespace

// Seen red with `x > low` for `x < low`, and with the test of NaN left out.
TEST_CASE("a limit holds for every number", "[parts]") {
  for (const double x : {-infinite, -2.0, -1.0, -0.0, 0.5, 1.0, 2.0, infinite}) {
    const double y = sinew_limited(x, -1.0, 1.0, 0.25);
    CHECK(y == std::min(std::max(x, -1.0), 1.0));
  }
  CHECK(sinew_limited(no_value, -1.0, 1.0, 0.25) == 0.25);
  for (const double x : {-infinite, -2.5, -0.0, 0.5, infinite})
    CHECK(sinew_magnitude(x) == std::abs(x));
  CHECK_FALSE(sinew_magnitude(no_value) <= infinite);
  CHECK(sinew_is_finite(1e308));
  for (const double x : {infinite, -infinite, no_value}) CHECK_FALSE(sinew_is_finite(x));
  CHECK(sinew_is_within(1.0, -1.0, 1.0));
  CHECK(sinew_is_within(-1.0, -1.0, 1.0));
  for (const double x : {no_value, 1.0000001, -infinite})
    CHECK_FALSE(sinew_is_within(x, -1.0, 1.0));
  CHECK(sinew_approached(0.0, 5.0, 0.5) == 0.5);
  CHECK(sinew_approached(0.0, -0.2, 0.5) == -0.2);
  CHECK(sinew_approached(2.0, no_value, 0.5) == 2.0);
}

// Seen red with the loop ended one coefficient early, and with the slope's factor i + 1.
TEST_CASE("polynomials and their slopes are those of the powers", "[parts]") {
  const double c[] = {1.0, -2.0, 0.5, 3.0};
  for (const double x : {-1.5, 0.0, 0.3, 2.0}) {
    CHECK(sinew_polynomial(c, 3, x) == Approx(1.0 - 2.0 * x + 0.5 * x * x + 3.0 * x * x * x));
    CHECK(sinew_polynomial_slope(c, 3, x) == Approx(-2.0 + x + 9.0 * x * x));
  }
  CHECK(sinew_polynomial(c, 0, 7.0) == 1.0);
  CHECK(sinew_polynomial_slope(c, 0, 7.0) == 0.0);
  CHECK(sinew_normalised(15.0, 10.0, 0.1) == Approx(0.5));
  CHECK(sinew_normalised(infinite, 10.0, 0.1) == 1.0);
  CHECK(sinew_normalised(-1e9, 10.0, 0.1) == -1.0);
  CHECK(sinew_normalised(no_value, 10.0, 0.1) == 0.0);
  CHECK(sinew_normalised(25.0, 10.0, 0.1) == 1.0);
  CHECK(sinew_normalised(-5.0, 10.0, 0.1) == -1.0);
}

// Seen red with the upper triangle read instead of the lower one, and with `least` ignored.
TEST_CASE("small systems are solved as Eigen solves them", "[parts]") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 1; n <= 8; ++n) {
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Matrix B = Matrix::NullaryExpr(n, n, [&] { return uniform(random); });
    Matrix A = B.transpose() * B + 0.1 * Matrix::Identity(n, n);
    const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(n, [&] { return uniform(random); });
    const Eigen::VectorXd expected = A.ldlt().solve(b);
    for (int i = 0; i < n; ++i)
      for (int j = i + 1; j < n; ++j) A(i, j) = no_value;  // is not read
    Eigen::VectorXd x = b;
    CHECK(sinew_solve(A.data(), n, 1e-12, x.data(), x.data()) == 0);
    CHECK((x - expected).norm() <= 1e-11 * expected.norm());
  }
  double singular[4] = {1.0, 0.0, 2.0, 4.0}, x[2] = {1.0, 1.0};
  CHECK(sinew_solve(singular, 2, 1e-12, x, x) == 1);
  CHECK(sinew_is_finite(x[0]));
  CHECK(sinew_is_finite(x[1]));
  double small[1] = {1e-6};
  CHECK(sinew_factorise(small, 1, 1e-5) == 1);
  CHECK(small[0] == 1.0);  // taken as 1
  double least[1] = {1e-5};
  CHECK(sinew_factorise(least, 1, 1e-5) == 1);  // not above it
  double no_number[1] = {no_value};
  CHECK(sinew_factorise(no_number, 1, 1e-12) == 1);
}

TEST_CASE("a substitution touches what is its own", "[parts]") {
  // A, and what stands behind it in memory.
  double A[9] = {4.0, 0.0, 2.0, 3.0, no_value, no_value, no_value, no_value, no_value};
  const double b[3] = {2.0, 1.0, no_value};
  double x[3] = {7.0, 7.0, no_value};
  CHECK(sinew_solve(A, 2, 1e-12, b, x) == 0);
  CHECK(x[0] == Approx(0.5));
  CHECK(x[1] == Approx(0.0).margin(1e-15));
  x[2] = 7.0;
  sinew_substitute(A, 2, b, x);
  CHECK(x[2] == 7.0);
}

// Seen red with `count + 1` steps and with a step that leaves the limits.
TEST_CASE("Newton's method takes its steps and stays within its limits", "[parts]") {
  struct Counted {
    int calls = 0;
  } counted;
  const auto cube = [](const void* context, double x, double* value, double* slope) {
    ++static_cast<Counted*>(const_cast<void*>(context))->calls;
    *value = x * x * x - 2.0;
    *slope = 3.0 * x * x;
  };
  const sinew_zero root = sinew_newton(cube, &counted, 1.0, 0.0, 2.0, 6);
  CHECK(root.x == Approx(std::cbrt(2.0)).epsilon(1e-14));
  CHECK(counted.calls == 7);
  CHECK(sinew_newton(cube, &counted, no_value, 0.5, 2.0, 0).x == 0.5);
  CHECK(sinew_newton(cube, &counted, 9.0, 0.5, 2.0, 0).x == 2.0);
  const sinew_zero below = sinew_newton(cube, &counted, 1.9, 1.5, 2.0, 4);
  CHECK(below.x == 1.5);  // the zero is below
  CHECK(below.residual == 1.5 * 1.5 * 1.5 - 2.0);
  const sinew_zero from_flat = sinew_newton(cube, &counted, 0.0, 0.0, 1.0, 3);
  CHECK(from_flat.x == 1.0);  // the zero is beyond
  CHECK(from_flat.residual == -1.0);
  const auto no_number = [](const void*, double, double* value, double* slope) {
    *value = *slope = no_value;
  };
  CHECK(sinew_newton(no_number, nullptr, 0.25, 0.0, 1.0, 5).x == 0.25);
}

// Seen red with `good = sample` before the fault is looked at: the NaN came back in the next tick.
TEST_CASE("a bad sample gives the last good value, then the safe one, and leaves no trace",
          "[parts]") {
  const std::pair<double, std::uint32_t> faults[] = {{no_value, SINEW_NOT_FINITE},
                                                     {infinite, SINEW_NOT_FINITE},
                                                     {11.0, SINEW_OUT_OF_RANGE},
                                                     {8.0, SINEW_JUMPED}};
  for (const auto& [bad, fault] : faults) {
    Channel c;
    const double good = c.value;
    REQUIRE(c.state.status == SINEW_FINE);
    CHECK(c.tick(bad) == (fault | SINEW_HELD));
    CHECK(c.value == good);
    CHECK(c.tick(good + 0.02) == SINEW_FINE);
    CHECK(c.value == good + 0.02);
    for (int i = 0; i < 3; ++i) {
      CHECK(c.tick(no_value) == (SINEW_NOT_FINITE | SINEW_HELD));
      CHECK(c.value == good + 0.02);
    }
    CHECK(c.tick(no_value) == (SINEW_NOT_FINITE | SINEW_SAFE));
    CHECK(c.value == -3.0);
    // It comes back after three good ones, and not before.
    c.tick(5.0);
    for (int i = 0; i < 2; ++i) CHECK(c.tick(5.1 + 0.1 * i) == SINEW_SAFE);
    CHECK(c.tick(5.3) == SINEW_FINE);
    CHECK(c.value == 5.3);
  }
}

// Seen red with the count of equal samples never growing, and with > for >=.
TEST_CASE("a value that stays for too long is frozen, and one that moves is not", "[parts]") {
  Channel c(1.0);
  c.tick(1.5);
  for (int i = 1; i < 5; ++i) CHECK(c.tick(1.5) == SINEW_FINE);
  CHECK(c.tick(1.5) == (SINEW_FROZEN | SINEW_HELD));
  CHECK(c.value == 1.5);
  CHECK(c.tick(1.6) == SINEW_FINE);
  c.l.frozen_ticks = 0;
  for (int i = 0; i < 50; ++i) CHECK(c.tick(1.6) == SINEW_FINE);
  // And where a sample was missing in between.
  CHECK(c.tick(no_value) == (SINEW_NOT_FINITE | SINEW_HELD));
  CHECK(c.tick(1.6) == SINEW_FINE);
}

TEST_CASE("the count of equal samples begins again with every move", "[parts]") {
  Channel c(1.0);
  c.tick(1.5);
  for (int i = 1; i < 5; ++i) CHECK(c.tick(1.5) == SINEW_FINE);
  CHECK(c.tick(1.6) == SINEW_FINE);
  for (int i = 1; i < 5; ++i) CHECK(c.tick(1.6) == SINEW_FINE);
  CHECK(c.tick(1.6) == (SINEW_FROZEN | SINEW_HELD));
  // After a missing sample, too.
  Channel d(1.0);
  d.tick(no_value);
  CHECK(d.tick(1.5) == SINEW_FINE);
  for (int i = 1; i < 5; ++i) CHECK(d.tick(1.5) == SINEW_FINE);
  CHECK(d.tick(1.5) == (SINEW_FROZEN | SINEW_HELD));
  // It ends at the largest number, and one equal sample may be too many.
  d.state.same_ticks = 0xffffffffU;
  CHECK((d.tick(1.5) & SINEW_FROZEN) != 0U);
  Channel strict(1.0);
  strict.l.frozen_ticks = 1;
  CHECK(strict.tick(1.1) == SINEW_FINE);
  CHECK(strict.tick(1.1) == (SINEW_FROZEN | SINEW_HELD));
}

TEST_CASE("a channel starts safe whatever the memory held, and its bits are the documented ones",
          "[parts]") {
  sinew_channel channel;
  std::memset(&channel, 0xff, sizeof channel);
  const Channel reference;
  sinew_channel_start(&channel, &reference.l);
  CHECK(channel.good == reference.l.safe);
  CHECK(channel.last == reference.l.safe);
  CHECK(channel.bad_ticks == reference.l.hold_ticks);
  CHECK(channel.same_ticks == 0U);
  CHECK(channel.good_ticks == 0U);
  CHECK(channel.status == SINEW_SAFE);
  const std::pair<unsigned, unsigned> bits[] = {
      {SINEW_FINE, 0},   {SINEW_NOT_FINITE, 1}, {SINEW_OUT_OF_RANGE, 2}, {SINEW_JUMPED, 4},
      {SINEW_FROZEN, 8}, {SINEW_HELD, 32},      {SINEW_SAFE, 64}};
  for (const auto& [bit, documented] : bits) CHECK(bit == documented);
}

TEST_CASE("a safe channel comes back after good samples in a row, each within a step of the last",
          "[parts]") {
  Channel c(1.0);
  for (int i = 0; i < 4; ++i) c.tick(no_value);
  REQUIRE((c.state.status & SINEW_SAFE) != 0U);
  c.tick(5.0);
  CHECK(c.tick(5.1) == SINEW_SAFE);
  CHECK(c.tick(no_value) == (SINEW_NOT_FINITE | SINEW_SAFE));  // from the beginning
  c.tick(5.2);
  CHECK(c.tick(5.3) == SINEW_SAFE);
  CHECK(c.tick(6.8) == (SINEW_JUMPED | SINEW_SAFE));  // 1.5 in one tick
  CHECK(c.tick(6.9) == SINEW_SAFE);
  CHECK(c.tick(7.0) == SINEW_SAFE);
  CHECK(c.tick(7.1) == SINEW_FINE);
}

TEST_CASE("a jump over zero is a jump", "[parts]") {
  Channel c(0.9);
  CHECK(c.tick(-0.4) == (SINEW_JUMPED | SINEW_HELD));
}

TEST_CASE("a sample out of the range is none, however small the step to it", "[parts]") {
  Channel c(9.8);
  CHECK(c.tick(10.0) == SINEW_FINE);
  CHECK(c.tick(10.2) == (SINEW_OUT_OF_RANGE | SINEW_HELD));
  CHECK(c.value == 10.0);
}

TEST_CASE("a move during missing samples is none that jumps", "[parts]") {
  Channel c(0.0);
  c.tick(no_value);
  c.tick(no_value);
  CHECK(c.tick(2.5) == SINEW_FINE);  // three ticks at 1 a tick
  CHECK(c.tick(4.0) == (SINEW_JUMPED | SINEW_HELD));
}

// Seen red with the place taken from `written % (capacity - 1)`.
TEST_CASE("the ring hands records on in order and counts what it loses", "[parts]") {
  std::uint64_t memory[4];
  sinew_ring ring{};
  CHECK(sinew_ring_start(&ring, memory, sizeof *memory, 3) == 1);
  CHECK(sinew_ring_start(&ring, memory, 0, 4) == 1);
  CHECK(sinew_ring_start(&ring, memory, sizeof *memory, 0) == 1);
  CHECK(sinew_ring_start(&ring, memory, sizeof *memory, 1) == 0);
  std::memset(&ring, 0xff, sizeof ring);
  REQUIRE(sinew_ring_start(&ring, memory, sizeof *memory, 4) == 0);
  CHECK(ring.written + ring.read + ring.lost == 0U);
  CHECK(sinew_ring_waiting(&ring) == 0U);
  std::uint64_t next = 0, expected = 0, got = 0;
  CHECK(sinew_ring_take(&ring, &got) == 0);
  ring.written = ring.read = 0xfffffffeU;  // over the end of the numbers
  for (int round = 0; round < 5; ++round) {
    for (int i = 0; i < 4; ++i) {
      CHECK(sinew_ring_put(&ring, &next) == 1);
      ++next;
    }
    CHECK(sinew_ring_put(&ring, &next) == 0);
    for (int i = 0; i < 4; ++i) {
      CHECK(sinew_ring_take(&ring, &got) == 1);
      CHECK(got == expected++);
    }
  }
  CHECK(ring.lost == 5);
  for (int i = 0; i < 4; ++i) sinew_ring_put(&ring, &next);
  ring.lost = 0xffffffffU;  // the count ends there
  CHECK(sinew_ring_put(&ring, &next) == 0);
  CHECK(ring.lost == 0xffffffffU);
}

TEST_CASE("one thread writes the ring while another reads it", "[parts]") {
  struct Record {
    std::uint64_t number, again;
  };
  static Record memory[64];
  sinew_ring ring{};
  REQUIRE(sinew_ring_start(&ring, memory, sizeof *memory, 64) == 0);
  constexpr std::uint64_t count = 20000;
  std::thread writer([&] {
    for (std::uint64_t i = 0; i < count;) {
      const Record record{i, ~i};
      if (sinew_ring_put(&ring, &record))
        ++i;
      else
        std::this_thread::yield();
    }
  });
  std::uint64_t next = 0, wrong = 0;
  while (next < count) {
    Record record{};
    if (!sinew_ring_take(&ring, &record)) {
      std::this_thread::yield();
      continue;
    }
    wrong += record.number != next || record.again != ~next;
    ++next;
  }
  writer.join();
  CHECK(wrong == 0);
}

/// By the polynomial's definition.
std::uint32_t crc32_bit_by_bit(unsigned char byte) {
  std::uint32_t sum = 0xffffffffU ^ byte;
  for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0U ? (sum >> 1) ^ 0xedb88320U : sum >> 1;
  return ~sum;
}

// Seen red with the table's last word changed.
TEST_CASE("the checksum is CRC-32 and sees every single bit", "[parts]") {
  CHECK(sinew_checksum(0, "123456789", 9) == 0xcbf43926U);
  CHECK(sinew_checksum(sinew_checksum(0, "1234", 4), "56789", 5) == 0xcbf43926U);
  CHECK(sinew_checksum(0, "", 0) == 0);
  for (unsigned byte = 0; byte < 256; ++byte) {
    const auto data = static_cast<unsigned char>(byte);
    CHECK(sinew_checksum(0, &data, 1) == crc32_bit_by_bit(data));
  }
  unsigned char data[64] = {};
  const std::uint32_t sum = sinew_checksum(0, data, sizeof data);
  int unseen = 0;
  for (std::size_t bit = 0; bit < 8 * sizeof data; ++bit) {
    data[bit / 8] ^= static_cast<unsigned char>(1U << bit % 8);
    unseen += sinew_checksum(0, data, sizeof data) == sum;
    data[bit / 8] ^= static_cast<unsigned char>(1U << bit % 8);
  }
  CHECK(unseen == 0);
}
