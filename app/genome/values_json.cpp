// SPDX-License-Identifier: Apache-2.0
#include "genome/values_json.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "genome/json_text.hpp"

namespace quadrat::genome {
namespace {

template <typename Wanted>
std::string values_json_where(const ParameterValues& values, const Wanted& is_wanted) {
    std::string text = "{";
    for (const Parameter& p : parameter_table()) {
        if (!is_wanted(p)) continue;
        if (text.size() > 1) text += ',';
        text += fmt::format(R"("{}":{})", p.name, shortest(values[p.id]));
    }
    return text + "}";
}

float value_from(const nlohmann::json& value, const Parameter& p, std::string_view source, std::string_view place) {
    // Rounded to float before it is compared: 0.94 in the file is the 0.94F of the table.
    const float number = value.is_number() ? static_cast<float>(value.get<double>()) : p.max + 1.0F;
    if (number >= p.min && number <= p.max) return number;
    throw base::InputError(fmt::format("{}: {}.{} is {}; it should be a number from {} to {}", source, place, p.name,
                                       brief(value), shortest(p.min), shortest(p.max)));
}

}  // namespace

std::string values_json(const ParameterValues& values) {
    return values_json_where(values, [](const Parameter&) { return true; });
}

std::string values_json(const ParameterValues& values, Genome genome) {
    return values_json_where(
        values, [genome](const Parameter& p) { return genome == Genome::Full || p.genome == Genome::Classic; });
}

std::string seeds_json(const PerAspect<base::Seed>& seeds) {
    return fmt::format(R"({{"trees":"{}","land":"{}","sky":"{}"}})", text_of(seeds[Aspect::Trees]),
                       text_of(seeds[Aspect::Land]), text_of(seeds[Aspect::Sky]));
}

ParameterValues values_from(const nlohmann::json& value, std::string_view source, std::string_view place) {
    if (!value.is_object())
        throw base::InputError(fmt::format("{}: {} is {}; it should be an object", source, place, brief(value)));
    ParameterValues values;
    for (const auto& entry : value.items()) {
        const auto id = parameter_named(entry.key());
        if (!id)
            throw base::InputError(
                fmt::format("{}: {} has the unknown parameter {}; `quadrat breed --stdio` lists the known ones", source,
                            place, brief(nlohmann::json(entry.key()))));
        values.set(*id, value_from(entry.value(), parameter(*id), source, place));
    }
    return values;
}

base::Seed seed_from(const nlohmann::json& value, std::string_view source, std::string_view place) {
    const auto seed = value.is_string() ? seed_of(value.get_ref<const std::string&>()) : std::nullopt;
    if (!seed)
        throw base::InputError(
            fmt::format("{}: {} is {}; it should be 16 hexadecimal digits in quotes", source, place, brief(value)));
    return *seed;
}

PerAspect<base::Seed> seeds_from(const nlohmann::json& value, std::string_view source, std::string_view place) {
    require_object(value, {"trees", "land", "sky"}, source, place);
    PerAspect<base::Seed> seeds;
    for (const Aspect aspect : kAspects) {
        const std::string key = fmt::format("{}.{}", place, name_of(aspect));
        const auto found = value.find(std::string(name_of(aspect)));
        if (found == value.end()) throw base::InputError(fmt::format("{}: the key {} is missing", source, key));
        seeds[aspect] = seed_from(*found, source, key);
    }
    return seeds;
}

}  // namespace quadrat::genome
