// SPDX-License-Identifier: Apache-2.0
#include "genome/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <vector>

#include "base/error.hpp"

namespace quadrat::genome {
namespace {

using nlohmann::json;

std::string printable(std::string_view text, std::size_t limit) {
    std::string clean;
    for (const char c : text.substr(0, limit)) clean.push_back(c >= ' ' && c <= '~' ? c : '?');
    return text.size() > limit ? clean + "..." : clean;
}

// nlohmann says "[json.exception.parse_error.101] parse error at line 1, column 5: syntax error while …".
std::string reason_of(const json::exception& error) {
    std::string_view what = error.what();
    for (const std::string_view lead : {"syntax error ", "parse error: "})
        if (const auto at = what.find(lead); at != std::string_view::npos) return printable(what.substr(at), 160);
    if (const auto at = what.find("] "); at != std::string_view::npos) what.remove_prefix(at + 2);
    return printable(what, 160);
}

auto line_at(std::string_view text, std::size_t byte) {
    return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size())), '\n');
}

// The parser keeps the last of two equal keys; we would rather know. It also nests as deep as memory goes.
class Strictness {
  public:
    explicit Strictness(std::string_view source) : source_(source) {}

    bool operator()(int depth, json::parse_event_t event, const json& parsed) {
        using Event = json::parse_event_t;
        if (event == Event::object_start) keys_.emplace_back();
        if (event == Event::object_end) keys_.pop_back();
        if ((event == Event::object_start || event == Event::array_start) && depth >= static_cast<int>(kDeepestJson))
            throw base::InputError(fmt::format("{}: nested deeper than {} levels", source_, kDeepestJson));
        if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second)
            throw base::InputError(fmt::format("{}: the key {} stands twice in one object", source_, brief(parsed)));
        return true;
    }

  private:
    std::string_view source_;
    std::vector<std::set<std::string>> keys_;
};

}  // namespace

json parse_json(std::string_view text, std::string_view source) {
    try {
        Strictness strictness(source);
        return json::parse(text.begin(), text.end(), [&](int depth, json::parse_event_t event, const json& parsed) {
            return strictness(depth, event, parsed);
        });
    } catch (const json::parse_error& error) {
        // The byte counts from 1 and is the last one read.
        const auto line = line_at(text, error.byte > 0 ? error.byte - 1 : 0);
        throw base::InputError(fmt::format("{}:{}: not JSON: {}", source, line, reason_of(error)));
    } catch (const json::exception& error) {
        throw base::InputError(fmt::format("{}: not usable JSON: {}", source, reason_of(error)));
    }
}

std::string brief(const json& value) {
    constexpr std::size_t kLimit = 40;
    if (value.is_object()) return "an object";
    if (value.is_array()) return "a list";
    if (value.is_string()) return '"' + printable(value.get_ref<const std::string&>(), kLimit) + '"';
    if (value.is_number_float()) return shortest(value.get<double>());
    return value.dump();
}

void require_object(const json& value, std::initializer_list<std::string_view> known, std::string_view source,
                    std::string_view place) {
    if (!value.is_object())
        throw base::InputError(fmt::format("{}: {} is {}; it should be an object", source, place, brief(value)));
    for (const auto& entry : value.items())
        if (std::find(known.begin(), known.end(), entry.key()) == known.end())
            throw base::InputError(fmt::format("{}: {} has the unknown key {}; it knows {}", source, place,
                                               brief(json(entry.key())), fmt::join(known, ", ")));
}

const json& member(const json& object, std::string_view key, std::string_view source) {
    const auto found = object.find(std::string(key));
    if (found == object.end()) throw base::InputError(fmt::format("{}: the key {} is missing", source, key));
    return *found;
}

std::string shortest(float value) { return fmt::format("{}", value); }
std::string shortest(double value) { return fmt::format("{}", value); }

std::string text_of(base::Seed seed) { return fmt::format("{:016x}", seed.value); }

std::optional<base::Seed> seed_of(std::string_view text) {
    base::Seed seed;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed.value, 16);
    if (text.size() != 16 || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return seed;
}

}  // namespace quadrat::genome
