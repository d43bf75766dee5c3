// SPDX-License-Identifier: Apache-2.0
#include "breeding/json_vectors.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "genome/json_text.hpp"

namespace quadrat::breeding {

using genome::brief;
using nlohmann::json;

std::vector<double> vector_from(const json& value, std::size_t count, std::string_view source, const std::string& place,
                                double low, double high, std::string_view what) {
    if (!value.is_array() || value.size() != count)
        throw base::InputError(fmt::format("{}: {} should be a list of {} numbers", source, place, count));
    std::vector<double> vector;
    for (const json& element : value) {
        if (!element.is_number() || element.get<double>() < low || element.get<double>() > high)
            throw base::InputError(fmt::format("{}: {} holds {}; {}", source, place, brief(element), what));
        vector.push_back(element.get<double>());
    }
    return vector;
}

std::vector<double> shares_from(const json& value, std::size_t count, std::string_view source,
                                const std::string& place) {
    return vector_from(value, count, source, place, 0, 1, "it should be a number from 0 to 1");
}

double evidence_from(const json& value, std::string_view source, const std::string& place) {
    if (!value.is_number() || value > 0)
        throw base::InputError(fmt::format("{}: {}.evidence is {}; the logarithm of a probability is at most 0", source,
                                           place, brief(value)));
    return value.get<double>();
}

}  // namespace quadrat::breeding
