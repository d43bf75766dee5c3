// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "genome/aspect.hpp"

namespace quadrat::genome {

// One a row. Who names one includes genome/parameter_ids.hpp; all others need not be compiled anew for another row.
enum class ParameterId : std::size_t;

// Which genomes hold a parameter. Classic ones are in every genome; Full ones keep their default in the classic one.
enum class Genome { Classic, Full };

// The unit of a parameter whose values are kinds, not amounts: what lies between two of them is neither.
inline constexpr std::string_view kChoice = "choice";

// The one place where a parameter has its name, aspect, unit, range, default and bits.
struct Parameter {
    ParameterId id;
    std::string_view name;  // "tree.branch_angle_deg"
    Aspect aspect;
    std::string_view unit;  // "deg", "m", "ratio", kChoice, or "" for a count
    float min;
    float max;
    float default_value;
    int bits;  // 1 to 8
    Genome genome;
    std::string_view meaning;
};

std::span<const Parameter> parameter_table();  // all, in the order of ParameterId
const Parameter& parameter(ParameterId id);
std::optional<ParameterId> parameter_named(std::string_view name);
std::vector<ParameterId> parameters_of(Aspect aspect, Genome genome);  // in table order

// A value for every parameter, each inside its range.
class ParameterValues {
  public:
    ParameterValues();  // the defaults
    float operator[](ParameterId id) const { return values_[static_cast<std::size_t>(id)]; }
    void set(ParameterId id, float value);  // clamped to the range; NaN gives the default
    friend bool operator==(const ParameterValues&, const ParameterValues&) = default;

  private:
    std::vector<float> values_;
};

}  // namespace quadrat::genome
