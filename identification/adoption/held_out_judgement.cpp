// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/held_out_judgement.h"

#include <fmt/format.h>

#include <algorithm>

#include "identification/diagnosis/confirmation.h"

namespace sinew::diagnosis {

namespace {

bool same(const RankedCause& a, const RankedCause& b) {
  return a.name == b.name && a.place == b.place;
}

void merge_alike(std::vector<NamedCause>& causes) {
  for (std::size_t i = 0; i < causes.size(); ++i)
    for (std::size_t k = causes.size(); k-- > i + 1;) {
      if (!same(causes[k].members.front(), causes[i].members.front())) continue;
      causes[i].also.push_back(causes[k].candidate);
      causes[i].also.insert(causes[i].also.end(), causes[k].also.begin(), causes[k].also.end());
      causes[i].parameters.insert(causes[i].parameters.end(), causes[k].parameters.begin(),
                                  causes[k].parameters.end());
      causes.erase(causes.begin() + static_cast<std::ptrdiff_t>(k));
    }
}

}  // namespace

void merge_members(Verdict& verdict) {
  for (NamedCause& cause : verdict.causes) {
    std::vector<RankedCause> members;
    for (const RankedCause& m : cause.members)
      if (std::none_of(members.begin(), members.end(),
                       [&](const RankedCause& other) { return same(other, m); }))
        members.push_back(m);
    cause.members = std::move(members);
  }
  merge_alike(verdict.causes);
  std::erase_if(verdict.ruled_out, [&](const RuledOut& out) {
    return std::any_of(verdict.causes.begin(), verdict.causes.end(), [&](const NamedCause& cause) {
      return std::any_of(cause.members.begin(), cause.members.end(), [&](const RankedCause& m) {
        return m.name == out.name && m.place == out.place;
      });
    });
  });
}

namespace {

/// Structure that the held-out logs could have confirmed, and did not.
void drop_unconfirmed(Unexplained& rest) {
  const bool had = !rest.depends_on.empty();
  std::erase_if(rest.depends_on,
                [](const Dependence& d) { return d.confirmed && !is_sure(*d.confirmed); });
  if (!had || !rest.depends_on.empty()) return;
  rest.none_of_the_known = false;
  rest.named_share = 1.0;
}

}  // namespace

void confirm_on_held_out(Verdict& verdict) {
  drop_unconfirmed(verdict.unexplained);
  std::vector<NamedCause> kept;
  for (NamedCause& cause : verdict.causes) {
    if (cause.stands || is_sure(cause.confirmed)) {
      kept.push_back(std::move(cause));
      continue;
    }
    const RankedCause& first = cause.members.front();
    verdict.ruled_out.push_back(
        {first.name, first.place, "no sure gain on the held-out logs", cause.log_odds});
    if (is_plain(cause))
      verdict.disagreements.push_back(
          {first.name, first.place, cause.cross_validated, -1, cause.left_without});
  }
  verdict.causes = std::move(kept);
  if (verdict.disagreements.empty() && verdict.most_excess.ratio > kExcess)
    verdict.disagreements.push_back(verdict.most_excess);
}

void decide_adoption(bool any_term, bool held_out, const Gain& gain,
                     std::vector<std::string> functions, Extension& extension) {
  if (!any_term) {
    extension.reason = "no cause with a term of its own was named";
  } else if (!held_out) {
    extension.reason =
        "no held-out log was given (--holdout): a gain on the training log proves nothing";
  } else if (!(gain.low > 0.0)) {
    extension.reason = "the interval of the held-out gain includes zero";
  } else {
    extension.adopted = true;
    extension.reason = "the whole interval of the held-out gain lies above zero";
    extension.functions = std::move(functions);
  }
}

void withhold(const std::string& because, Extension& extension) {
  if (!extension.adopted) return;
  extension.adopted = false;
  extension.functions.clear();
  extension.reason = because;
}

void tell_first_look(Findings& findings) {
  withhold("a first look adopts nothing; without --quick all samples are looked at",
           findings.extension);
  findings.headline = "At a first look: " + findings.headline;
}

void add_remarks(const std::vector<std::string>& changed, const std::vector<std::string>& refused,
                 bool any_term, Extension& extension) {
  std::vector<std::string> remarks = refused;
  if (extension.adopted) remarks.insert(remarks.end(), changed.begin(), changed.end());
  if (!any_term && !refused.empty()) extension.reason.clear();
  for (const std::string& remark : remarks)
    extension.reason += (extension.reason.empty() ? "" : "; ") + remark;
}

}  // namespace sinew::diagnosis
