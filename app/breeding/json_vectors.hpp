// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace quadrat::breeding {

// `count` numbers from low to high. Throws InputError naming source and place; `what` says what an element is: "a
// probability is a number from 0 to 1".
std::vector<double> vector_from(const nlohmann::json& value, std::size_t count, std::string_view source,
                                const std::string& place, double low, double high, std::string_view what);

std::vector<double> shares_from(const nlohmann::json& value, std::size_t count, std::string_view source,
                                const std::string& place);

// A logarithm of a probability.
double evidence_from(const nlohmann::json& value, std::string_view source, const std::string& place);

}  // namespace quadrat::breeding
