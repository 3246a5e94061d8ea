// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/signals.h"

#include <algorithm>
#include <cmath>

namespace sinew::truth {
namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

Motion::Motion(Course course, double amplitude, double top_speed, double seconds, Draw draw) {
  const bool with_sines =
      course == Course::sines || course == Course::mixed || course == Course::one_way;
  const bool with_strokes =
      course == Course::strokes || course == Course::mixed || course == Course::one_speed;
  const double sine_share = course == Course::sines ? 0.9 : course == Course::mixed ? 0.25 : 0.4;
  if (with_sines) {
    const int count = 5;
    for (int i = 0; i < count; ++i) {
      const double rate = 2.0 * pi * draw.log_uniform(0.1, 2.2);
      const double reach = amplitude * sine_share / count;
      const double fastest = top_speed * sine_share / count;
      sines_.push_back({std::min(reach * 2.0, fastest / rate), rate, draw.uniform(0.0, 2.0 * pi)});
    }
  }
  if (course == Course::one_sine)
    sines_.push_back({amplitude, top_speed / amplitude, draw.uniform(0.0, 2.0 * pi)});
  if (course == Course::one_way) drift_ = 0.55 * top_speed;
  if (!with_strokes) return;
  const double reach = course == Course::mixed ? 0.75 * amplitude : amplitude;
  double time = 0.0, place = 0.0;
  bool forward = draw.chance(0.5);
  while (time < seconds + 1.0) {
    Stroke s{};
    s.start = time;
    s.from = place;
    if (course == Course::one_speed) {
      s.distance = (forward ? reach : -reach) - place;
      s.speed = 0.5 * top_speed;
    } else {
      s.distance = draw.uniform(0.3, 1.0) * (forward ? reach : -reach) - place;
      s.speed = top_speed * draw.log_uniform(0.06, 0.7);
    }
    forward = !forward;
    s.ramp = course == Course::one_speed ? 0.04 : draw.uniform(0.08, 0.3);
    // Long enough to get anywhere, short enough that a log holds several strokes.
    const double way = std::abs(s.distance);
    s.speed = std::max(s.speed, way / 6.0);
    s.speed = std::min(s.speed, way / (1.2 * s.ramp));
    s.length = way / s.speed + s.ramp;
    time += s.length + (course == Course::one_speed ? 0.0 : draw.uniform(0.0, 0.15));
    place += s.distance;
    strokes_.push_back(s);
  }
}

// Speed rises and falls over `ramp` as a smooth step, so that the acceleration has no jumps.
Reference Motion::strokes(double time) {
  if (strokes_.empty()) return {};
  while (current_ + 1 < strokes_.size() && strokes_[current_ + 1].start <= time) ++current_;
  while (current_ > 0 && strokes_[current_].start > time) --current_;
  const Stroke& s = strokes_[current_];
  const double t = time - s.start, sign = s.distance < 0.0 ? -1.0 : 1.0;
  const double cruise = s.length - 2.0 * s.ramp;
  // Integral of the smooth step 3 u^2 - 2 u^3 is u^3 - u^4 / 2.
  const auto ramp = [&](double u) {
    return Reference{s.speed * s.ramp * (u * u * u - 0.5 * u * u * u * u),
                     s.speed * u * u * (3.0 - 2.0 * u), s.speed * 6.0 * u * (1.0 - u) / s.ramp};
  };
  Reference r;
  if (t < s.ramp) {
    r = ramp(std::max(0.0, t / s.ramp));
  } else if (t < s.ramp + cruise) {
    r = {s.speed * (0.5 * s.ramp + (t - s.ramp)), s.speed, 0.0};
  } else if (t < s.length) {
    const Reference back = ramp((s.length - t) / s.ramp);
    r = {s.speed * (s.ramp + cruise) - back.position, back.velocity, -back.acceleration};
  } else {
    r = {s.speed * (s.ramp + cruise), 0.0, 0.0};
  }
  return {s.from + sign * r.position, sign * r.velocity, sign * r.acceleration};
}

// Sines by turning a pointer a step at a time: twenty times faster than calling sin.
std::vector<Reference> Motion::table(double step, size_t count) {
  std::vector<Reference> out(count);
  for (size_t k = 0; k < count; ++k) {
    const double time = static_cast<double>(k) * step;
    out[k] = strokes(time);
    out[k].position += drift_ * time;
    out[k].velocity += drift_;
  }
  for (const Sine& s : sines_) {
    const double turn_c = std::cos(s.rate * step), turn_s = std::sin(s.rate * step);
    const double start = std::sin(s.phase);
    double c = std::cos(s.phase), v = start;
    for (size_t k = 0; k < count; ++k) {
      out[k].position += s.amplitude * (v - start);
      out[k].velocity += s.amplitude * s.rate * c;
      out[k].acceleration -= s.amplitude * s.rate * s.rate * v;
      const double next = c * turn_c - v * turn_s;
      v = c * turn_s + v * turn_c;
      c = next;
    }
  }
  return out;
}

Noise::Noise(Draw draw) : draw_(draw) {
  double w = draw_.uniform(0.2, 1.0), s = draw_.uniform(0.3, 1.0), r = draw_.uniform(0.0, 0.6);
  const double total = std::sqrt(w * w + s * s + r * r);
  white_ = w / total, slow_ = s / total, ring_ = r / total;
  pole_ = 1.0 - draw_.log_uniform(0.01, 0.3);
  slow_gain_ = std::sqrt(1.0 - pole_ * pole_);
  const double radius = draw_.uniform(0.9, 0.985), angle = draw_.uniform(0.1, 1.5);
  a1_ = 2.0 * radius * std::cos(angle);
  a2_ = -radius * radius;
  // Variance of an AR(2) process driven by unit noise.
  const double variance = (1.0 - a2_) / ((1.0 + a2_) * ((1.0 - a2_) * (1.0 - a2_) - a1_ * a1_));
  ring_gain_ = 1.0 / std::sqrt(variance);
  for (int i = 0; i < 200; ++i) next();
}

double Noise::next() {
  x_ = pole_ * x_ + slow_gain_ * draw_.normal();
  const double y = a1_ * y1_ + a2_ * y2_ + ring_gain_ * draw_.normal();
  y2_ = y1_;
  y1_ = y;
  return white_ * draw_.normal() + slow_ * x_ + ring_ * y;
}

}  // namespace sinew::truth
