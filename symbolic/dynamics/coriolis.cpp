// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/coriolis.h"

#include "symbolic/dynamics/composites.h"
#include "symbolic/dynamics/joint_angles.h"
#include "symbolic/dynamics/run_motion.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// Integrals over the masses beyond a joint m, about the origin o of the frame they are given in
/// (moments with r - o). With u = dr/dq_m and du its rate:
struct JointSums {
  Vector3ex F;  ///< of u
  Vector3ex N;  ///< of (r - o) x u
  Vector3ex D;  ///< of (dr - do) x u
  Vector3ex G;  ///< of du
  Vector3ex H;  ///< of (r - o) x du
};

/// The joint ahead of m with axis z, that turns at w: M_jm = z.N, C_jm = z.H and
/// C_mj = z.D + (w x z).N; that slides: M_jm = z.F, C_jm = z.G, C_mj = (w x z).F.
class CoriolisSweep {
 public:
  CoriolisSweep(DefinitionList& list, const JointTree& tree, const DynamicsPlan& plan,
                const std::vector<ex>& q, const std::vector<ex>& qd)
      : list_(list),
        tree_(tree),
        q_(q),
        qd_(qd),
        runs_(split_into_runs(tree, plan)),
        angles_(joint_angles(list, tree, runs_, q)),
        composites_(list, tree, runs_, angles_, q),
        n_(tree.links.size()),
        w_(n_, zero_vector()),
        frame_w_(runs_.runs.size(), zero_vector()),
        offset_rate_(runs_.runs.size(), zero_vector()),
        inner_(n_),
        motions_(runs_.runs.size()),
        result_{std::vector<ex>(n_ * n_, ex(0)), std::vector<ex>(n_ * n_, ex(0))} {}

  CoriolisAndMass run() {
    for (std::size_t r = 0; r < runs_.runs.size(); ++r) move_outward(r);
    for (std::size_t r = runs_.runs.size(); r-- > 0;) gather(r);
    for (std::size_t r = runs_.runs.size(); r-- > 0;) {
      if (runs_.runs[r].common_frame)
        close_common_frame(r);
      else if (link(runs_.runs[r].links[0]).type == JointType::prismatic)
        close_slider(r);
      else
        close_own_frame(r);
    }
    return std::move(result_);
  }

 private:
  const TreeLink& link(int i) const { return tree_.links[static_cast<std::size_t>(i)]; }
  std::size_t run_of(int i) const {
    return static_cast<std::size_t>(runs_.run_of[static_cast<std::size_t>(i)]);
  }
  const ex& position(int i) const { return q_[static_cast<std::size_t>(link(i).coordinate)]; }
  ex rate(int i) const { return link(i).sign * qd_[static_cast<std::size_t>(link(i).coordinate)]; }
  const CosSin& angle(int i) const { return angles_[static_cast<std::size_t>(i)]; }
  Vector3ex& w(int i) { return w_[static_cast<std::size_t>(i)]; }
  InnerMotion& inner(int i) { return inner_[static_cast<std::size_t>(i)]; }

  std::vector<ex> rates(const Run& run) const {
    std::vector<ex> values;
    for (int i : run.links) values.push_back(rate(i));
    return values;
  }

  std::vector<InnerMotion> inner_motions(const Run& run) {
    std::vector<InnerMotion> values;
    for (int i : run.links) values.push_back(inner(i));
    return values;
  }

  /// Angular velocities, and how fast the origins of the runs' frames move against their carriers'.
  void move_outward(std::size_t r) {
    const Run& run = runs_.runs[r];
    const int root = run.links[0];
    const std::string name = std::to_string(root + 1);
    if (const int parent = link(root).parent; parent >= 0) {
      frame_w_[r] = named(list_, "v" + name, transpose_times(link(root).R, w(parent)));
      offset_rate_[r] = named(list_, "do" + name, cross(w(parent), to_expression(run.origin)));
    }
    ex turn_rate = frame_w_[r][2];
    for (int i : run.links) {
      w(i) = frame_w_[r];
      if (link(i).type == JointType::prismatic) continue;
      const int parent = link(i).parent;
      const bool at_root = i == root;
      turn_rate = (at_root ? frame_w_[r][2] : w(parent)[2]) + rate(i);
      w(i) = turn_back(angle(i), frame_w_[r]);
      w(i)[2] = turn_rate;
      w(i) = named(list_, "w" + std::to_string(i + 1), w(i));
    }
  }

  /// Inner motions, from the tips to the base.
  void gather(std::size_t r) {
    const Run& run = runs_.runs[r];
    const int root = run.links[0];
    const std::string name = "E" + std::to_string(root + 1);
    InnerMotion before;
    if (run.common_frame) {
      const std::vector<InnerMotion> carried = inner_motions(run);
      motions_[r] = run_motion(list_, composites_.run(r), carried, frame_w_[r][2], rates(run));
      before = whole_motion(list_, composites_.run(r), carried, rates(run));
    } else if (link(root).type == JointType::prismatic) {
      before =
          sliding(list_, name, position(root), rate(root), inner(root), composites_.before(root));
    } else {
      before = turned(list_, name, angle(root), inner(root)) +
               turning(list_, name, rate(root), composites_.before(root));
    }
    const int parent = link(root).parent;
    if (parent < 0) return;
    before = rotated(list_, name + "r", link(root).R, before);
    inner(parent) = inner(parent) + shifted(list_, name + "s", to_expression(run.origin), before);
  }

  void set(std::vector<ex>& matrix, const char* letter, int i, int j, const ex& value) {
    const auto row = static_cast<std::size_t>(link(i).coordinate),
               col = static_cast<std::size_t>(link(j).coordinate);
    matrix[row * n_ + col] =
        named(list_, letter + std::to_string(row + 1) + "_" + std::to_string(col + 1),
              link(i).sign * link(j).sign * value);
  }
  void set_C(int i, int j, const ex& value) { set(result_.C, "C", i, j, value); }
  void set_M(int i, int j, const ex& value) {
    set(result_.M, "M", i, j, value);
    if (i != j) set(result_.M, "M", j, i, value);
  }

  void close_own_frame(std::size_t r) {
    const int m = runs_.runs[r].links[0];
    const PseudoInertia& J = composites_.beyond(m);
    const InnerMotion& E = inner(m);
    const Vector3ex& v = w(m);
    const std::string name = std::to_string(m + 1);
    const ex Y = named(list_, "Y" + name, E.Q[0][0] + E.Q[1][1]);
    JointSums sums;
    sums.F = {-J[1][3], J[0][3], ex(0)};
    sums.N = {-J[0][2], -J[1][2], named(list_, "Z" + name, J[0][0] + J[1][1])};
    sums.D = {v[1] * J[0][0] - v[0] * J[0][1] - E.Q[0][2],
              v[1] * J[0][1] - v[0] * J[1][1] - E.Q[1][2], v[1] * J[0][2] - v[0] * J[1][2] + Y};
    sums.G = {-v[2] * J[0][3] - E.p[1], -v[2] * J[1][3] + E.p[0], v[1] * J[1][3] + v[0] * J[0][3]};
    sums.H = {v[1] * J[1][1] + v[0] * J[0][1] + v[2] * J[1][2] - E.Q[2][0],
              -v[0] * J[0][0] - v[1] * J[0][1] - v[2] * J[0][2] - E.Q[2][1], Y};
    set_M(m, m, sums.N[2]);
    set_C(m, m, Y);
    sums = named_sums(m, sums);
    hand_to_carrier(m, m, turned_sums(angle(m), sums));
  }

  void close_slider(std::size_t r) {
    const int m = runs_.runs[r].links[0];
    const PseudoInertia& J = composites_.beyond(m);
    const Vector3ex S{J[0][3], J[1][3], J[2][3]};
    const Vector3ex p = named(list_, "p" + std::to_string(m + 1), cross(w(m), S) + inner(m).p);
    const Vector3ex axis_rate{w(m)[1], -w(m)[0], ex(0)};
    JointSums sums;
    sums.F = {ex(0), ex(0), J[3][3]};
    sums.N = {S[1], -S[0], ex(0)};
    sums.D = {p[1], -p[0], ex(0)};
    sums.G = {J[3][3] * axis_rate[0], J[3][3] * axis_rate[1], ex(0)};
    sums.H = cross(S, axis_rate);
    set_M(m, m, J[3][3]);
    sums = named_sums(m, sums);
    hand_to_carrier(m, m, before_slide(m, sums));
  }

  void close_common_frame(std::size_t r) {
    const std::vector<RunLink>& links = composites_.run(r);
    for (std::size_t k = links.size(); k-- > 0;) {
      couple_within_run(r, k);
      hand_to_carrier(links[0].link, links[k].link, named_sums(links[k].link, run_sums(r, k)));
    }
  }

  /// Entries of the joints of one run.
  void couple_within_run(std::size_t r, std::size_t k) {
    const std::vector<RunLink>& links = composites_.run(r);
    const RunLink& at = links[k];
    const RunLinkMotion& motion = motions_[r][k];
    ex mass = at.Z, row = motion.Y, column = motion.Y;
    set_M(at.link, at.link, mass);
    set_C(at.link, at.link, row);
    for (std::size_t j = k; links[j].parent >= 0;) {
      const auto& l = links[j].l;
      const std::string name = std::to_string(links[j].link + 1);
      j = static_cast<std::size_t>(links[j].parent);
      const ex along = named(list_, "lS" + name, l[0] * at.S[0] + l[1] * at.S[1]);
      const ex across = named(list_, "X" + name, l[0] * at.S[1] - l[1] * at.S[0]);
      mass = named(list_, "M", mass + along);
      row = named(list_, "C", row + motions_[r][j].w * across);
      column = named(list_, "C", column + l[0] * motion.G[1] - l[1] * motion.G[0]);
      set_M(at.link, links[j].link, mass);
      set_C(at.link, links[j].link, row);
      set_C(links[j].link, at.link, column);
    }
  }

  /// A run's joint about the origin of {P}.
  JointSums run_sums(std::size_t r, std::size_t k) const {
    const RunLink& at = composites_.run(r)[k];
    const RunLinkMotion& motion = motions_[r][k];
    const auto& K = at.K;
    const Vector3ex& v = frame_w_[r];
    JointSums sums;
    sums.F = {-at.S[1], at.S[0], ex(0)};
    sums.N = {-K[0][2], -K[1][2], at.Z + at.o[0] * at.S[0] + at.o[1] * at.S[1]};
    sums.D = {
        v[1] * K[0][0] - v[0] * K[0][1] - motion.Q_z[0],
        v[1] * K[1][0] - v[0] * K[1][1] - motion.Q_z[1],
        v[1] * K[0][2] - v[0] * K[1][2] + motion.Y + motion.v[0] * at.S[0] + motion.v[1] * at.S[1]};
    sums.G = {motion.G[0], motion.G[1], v[1] * at.S[1] + v[0] * at.S[0]};
    sums.H = {v[1] * K[1][1] + v[0] * K[0][1] + motion.T[0],
              -v[0] * K[0][0] - v[1] * K[1][0] + motion.T[1],
              motion.Y + at.o[0] * motion.G[1] - at.o[1] * motion.G[0]};
    return sums;
  }

  JointSums named_sums(int m, const JointSums& sums) const {
    const std::string name = std::to_string(m + 1);
    return {named(list_, "cF" + name, sums.F), named(list_, "cN" + name, sums.N),
            named(list_, "cD" + name, sums.D), named(list_, "cG" + name, sums.G),
            named(list_, "cH" + name, sums.H)};
  }

  static JointSums turned_sums(const CosSin& angle, const JointSums& sums) {
    return {turn(angle, sums.F), turn(angle, sums.N), turn(angle, sums.D), turn(angle, sums.G),
            turn(angle, sums.H)};
  }

  /// About an origin that the present one is away from by `offset` and moves against at
  /// `offset_rate`.
  static JointSums moved_sums(const Vector3ex& offset, const Vector3ex& offset_rate,
                              const JointSums& sums) {
    return {sums.F, sums.N + cross(offset, sums.F), sums.D + cross(offset_rate, sums.F), sums.G,
            sums.H + cross(offset, sums.G)};
  }

  /// In the frame of slider p before its motion.
  JointSums before_slide(int p, const JointSums& sums) {
    const ex& q = position(p);
    return moved_sums({ex(0), ex(0), q}, {w(p)[1] * q, -w(p)[0] * q, rate(p)}, sums);
  }

  /// Sums of joint m, given in the frame of `root`'s run, for all joints nearer to the base.
  void hand_to_carrier(int root, int m, const JointSums& sums) {
    const int parent = link(root).parent;
    if (parent < 0) return;
    const NumberMatrix3& R = link(root).R;
    const std::size_t r = run_of(root);
    const JointSums given = named_sums(m, sums);
    const JointSums rotated =
        named_sums(m, {times(R, given.F), times(R, given.N), times(R, given.D), times(R, given.G),
                       times(R, given.H)});
    const JointSums at =
        named_sums(m, moved_sums(to_expression(runs_.runs[r].origin), offset_rate_[r], rotated));
    if (runs_.runs[run_of(parent)].common_frame)
      pass_common_frame(parent, m, at);
    else
      pass_own_frame(parent, m, at);
  }

  void pass_own_frame(int p, int m, const JointSums& at) {
    const Vector3ex axis_rate{w(p)[1], -w(p)[0], ex(0)};
    const bool slides = link(p).type == JointType::prismatic;
    set_M(p, m, slides ? at.F[2] : at.N[2]);
    set_C(p, m, slides ? at.G[2] : at.H[2]);
    const Vector3ex& moment = slides ? at.F : at.N;
    const ex turning = axis_rate[0] * moment[0] + axis_rate[1] * moment[1];
    set_C(m, p, slides ? turning : at.D[2] + turning);
    hand_to_carrier(p, m, slides ? before_slide(p, at) : turned_sums(angle(p), at));
  }

  void pass_common_frame(int p, int m, const JointSums& at) {
    const std::size_t r = run_of(p);
    const std::vector<RunLink>& links = composites_.run(r);
    std::size_t k = 0;
    while (links[k].link != p) ++k;
    const JointSums sums = named_sums(m, turned_sums(links[k].angle, at));
    const Vector3ex &v = frame_w_[r], &F = sums.F, &G = sums.G;
    ex mass = sums.N[2], column = sums.H[2];
    ex row = named(list_, "C", sums.D[2] + v[1] * sums.N[0] - v[0] * sums.N[1]);
    set_M(p, m, mass);
    set_C(p, m, column);
    set_C(m, p, row);
    for (std::size_t j = k; links[j].parent >= 0;) {
      const auto& l = links[j].l;
      j = static_cast<std::size_t>(links[j].parent);
      mass = named(list_, "M", mass + l[0] * F[1] - l[1] * F[0]);
      column = named(list_, "C", column + l[0] * G[1] - l[1] * G[0]);
      const ex along = named(list_, "lF", l[0] * F[0] + l[1] * F[1]);
      const ex across = named(list_, "vl", v[0] * l[0] + v[1] * l[1]);
      row = named(list_, "C", row - motions_[r][j].w * along + across * F[2]);
      set_M(links[j].link, m, mass);
      set_C(links[j].link, m, column);
      set_C(m, links[j].link, row);
    }
    const RunLink& end = links[k];
    const auto& d = motions_[r][k].v;
    const Vector3ex o{end.o[0], end.o[1], ex(0)};
    const Vector3ex rate_of_o{
        d[0], d[1],
        named(list_, "v" + std::to_string(p + 1) + "z", v[0] * end.o[1] - v[1] * end.o[0])};
    hand_to_carrier(links[0].link, m, moved_sums(o, rate_of_o, sums));
  }

  DefinitionList& list_;
  const JointTree& tree_;
  const std::vector<ex>& q_;
  const std::vector<ex>& qd_;
  Runs runs_;
  std::vector<CosSin> angles_;
  Composites composites_;
  std::size_t n_;
  std::vector<Vector3ex> w_;            // of links, in their axes
  std::vector<Vector3ex> frame_w_;      // of runs' frames before motion
  std::vector<Vector3ex> offset_rate_;  // of runs' origins against the carriers', carriers' axes
  std::vector<InnerMotion> inner_;      // beyond links, in their axes; own joint excluded
  std::vector<std::vector<RunLinkMotion>> motions_;
  CoriolisAndMass result_;
};

}  // namespace

CoriolisAndMass coriolis_matrix(DefinitionList& list, const JointTree& tree,
                                const DynamicsPlan& plan, const std::vector<ex>& q,
                                const std::vector<ex>& qd) {
  return CoriolisSweep(list, tree, plan, q, qd).run();
}

}  // namespace sinew
