// SPDX-License-Identifier: Apache-2.0
// What anybody may send by a broker: a topic and a value, a line each. It is answered in JSON, and only what is
// well-formed is done.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "fleet/orders.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat::fleet;
    const std::string text(reinterpret_cast<const char*>(bytes), size);
    const std::size_t line = std::min(text.find('\n'), text.size());
    const std::string what = text.substr(0, line), value = text.substr(std::min(line + 1, text.size()));
    const std::string trouble = trouble_of_order(what, value);
    const bool is_known =
        what == "standby" || what == "wake" || what == "restart" || what == "theme" || what == "language";
    if (trouble.empty() && (!is_known || value.size() > kLongestOrder)) std::abort();
    const auto answer = nlohmann::json::parse(answer_json(what, value, trouble));
    if (answer.at("done").get<bool>() != trouble.empty()) std::abort();
    Orders orders;
    orders.choices = [&value](const std::string&) { return std::vector{value}; };
    for (const auto& [topic, told] : discovery_of("homeassistant", what, value, &orders)) {
        if (topic.find_first_of("+#\n") != std::string::npos || !nlohmann::json::accept(told)) std::abort();
    }
    return 0;
}
