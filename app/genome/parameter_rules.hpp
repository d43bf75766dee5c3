// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string_view>

#include "genome/parameter_table.hpp"

namespace quadrat::genome {

// Parameters of one aspect that depend on each other ("Affective scene generation" 2006, section 6).
struct ParameterRule {
    enum class Bound { AtLeast, AtMost };
    ParameterId id;  // gives way
    Bound bound;
    ParameterId other;
    float factor;
    float offset;  // the bound is factor · other + offset
    std::string_view reason;
};

std::span<const ParameterRule> parameter_rules();

// Moves what breaks a rule just so far that it no longer does, in table order; a range's end goes before a rule.
void make_consistent(Aspect aspect, ParameterValues& values);

}  // namespace quadrat::genome
