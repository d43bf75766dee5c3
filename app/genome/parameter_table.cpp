// SPDX-License-Identifier: Apache-2.0
#include "genome/parameter_table.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "genome/parameter_ids.hpp"

namespace quadrat::genome {
namespace {

constexpr auto Classic = Genome::Classic;
[[maybe_unused]] constexpr auto Full = Genome::Full;

constexpr std::array<Parameter, kParameterCount> kTable{{
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) \
    {ParameterId::id, name, Aspect::Trees, unit, min, max, standard, bits, genome, meaning},
#include "genome/parameters_trees.inc"
#undef PARAMETER
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) \
    {ParameterId::id, name, Aspect::Land, unit, min, max, standard, bits, genome, meaning},
#include "genome/parameters_land.inc"
#undef PARAMETER
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) \
    {ParameterId::id, name, Aspect::Sky, unit, min, max, standard, bits, genome, meaning},
#include "genome/parameters_sky.inc"
#undef PARAMETER
}};

constexpr bool rows_stand_at_their_id() {
    for (std::size_t i = 0; i < kTable.size(); ++i)
        if (kTable[i].id != static_cast<ParameterId>(i)) return false;
    return true;
}
static_assert(rows_stand_at_their_id());

}  // namespace

std::span<const Parameter> parameter_table() { return kTable; }

const Parameter& parameter(ParameterId id) {
    assert(id < ParameterId::count);
    return kTable[static_cast<std::size_t>(id)];
}

std::optional<ParameterId> parameter_named(std::string_view name) {
    const auto found = std::ranges::find(kTable, name, &Parameter::name);
    if (found == kTable.end()) return std::nullopt;
    return found->id;
}

std::vector<ParameterId> parameters_of(Aspect aspect, Genome genome) {
    std::vector<ParameterId> ids;
    for (const Parameter& p : kTable)
        if (p.aspect == aspect && (genome == Genome::Full || p.genome == Genome::Classic)) ids.push_back(p.id);
    return ids;
}

ParameterValues::ParameterValues() : values_(kParameterCount) {
    std::ranges::transform(kTable, values_.begin(), &Parameter::default_value);
}

void ParameterValues::set(ParameterId id, float value) {
    const Parameter& p = parameter(id);
    values_[static_cast<std::size_t>(id)] = std::isnan(value) ? p.default_value : std::clamp(value, p.min, p.max);
}

}  // namespace quadrat::genome
