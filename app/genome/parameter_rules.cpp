// SPDX-License-Identifier: Apache-2.0
#include "genome/parameter_rules.hpp"

#include <algorithm>
#include <array>

#include "genome/parameter_ids.hpp"

namespace quadrat::genome {
namespace {

using Bound = ParameterRule::Bound;

constexpr std::array kRules{
#define AT_LEAST(id, other, factor, offset, reason) \
    ParameterRule{ParameterId::id, Bound::AtLeast, ParameterId::other, factor, offset, reason},
#define AT_MOST(id, other, factor, offset, reason) \
    ParameterRule{ParameterId::id, Bound::AtMost, ParameterId::other, factor, offset, reason},
#include "genome/parameter_rules.inc"
#undef AT_LEAST
#undef AT_MOST
};

}  // namespace

std::span<const ParameterRule> parameter_rules() { return kRules; }

void make_consistent(Aspect aspect, ParameterValues& values) {
    for (const ParameterRule& rule : kRules) {
        if (parameter(rule.id).aspect != aspect) continue;
        const float bound = rule.factor * values[rule.other] + rule.offset;
        const float value = values[rule.id];
        values.set(rule.id, rule.bound == Bound::AtLeast ? std::max(value, bound) : std::min(value, bound));
    }
}

}  // namespace quadrat::genome
