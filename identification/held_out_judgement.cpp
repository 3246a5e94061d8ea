// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/held_out_judgement.h"

#include <fmt/format.h>

#include <algorithm>

namespace sinew::diagnosis {

void merge_members(Verdict& verdict) {
  for (NamedCause& cause : verdict.causes) {
    std::vector<RankedCause> members;
    for (const RankedCause& m : cause.members)
      if (std::none_of(members.begin(), members.end(), [&](const RankedCause& other) {
            return other.name == m.name && other.place == m.place;
          }))
        members.push_back(m);
    cause.members = std::move(members);
  }
}

void confirm_on_held_out(Verdict& verdict) {
  std::vector<NamedCause> kept;
  for (NamedCause& cause : verdict.causes) {
    if (cause.held_out.share > 0.0) {
      kept.push_back(std::move(cause));
      continue;
    }
    const RankedCause& first = cause.members.front();
    verdict.ruled_out.push_back(
        {first.name, first.place, "no gain on the held-out logs", cause.statistic, cause.p_family});
  }
  verdict.causes = std::move(kept);
}

void decide_adoption(bool any_term, bool held_out, const Gain& gain,
                     std::vector<std::string> functions, Extension& extension) {
  const std::string falls = fmt::format(
      "on the held-out logs the squared error falls by {:.1f} % (95 %: {:.1f} to {:.1f} %)",
      100.0 * gain.share, 100.0 * gain.low, 100.0 * gain.high);
  if (!any_term) {
    extension.reason = "no cause with a term of its own was named";
  } else if (!held_out) {
    extension.reason =
        "no held-out log was given (--holdout): a gain on the training log proves nothing";
  } else if (!(gain.low > 0.0)) {
    extension.reason = falls + ", which includes nothing at all";
  } else {
    extension.adopted = true;
    extension.reason = falls;
    extension.functions = std::move(functions);
  }
}

}  // namespace sinew::diagnosis
