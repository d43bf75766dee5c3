// SPDX-License-Identifier: Apache-2.0
#include "site/layers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace quadrat::site {
namespace {

constexpr std::string_view kMark = "\n#% laid over: ";
constexpr std::array<std::string_view, 7> kOfTheCurator{"attract", "breeding", "hours", "text",
                                                        "themes",  "visit",    "words"};
constexpr std::array<std::string_view, 2> kWhole{"themes", "exceptions"};

bool is_whole(std::string_view name) { return std::ranges::find(kWhole, name) != kWhole.end(); }

// Moved, not copied: a copy does not know its line any more.
void put(toml::table& to, const toml::key& key, toml::node& node) {
    node.visit([&](auto& one) { to.insert_or_assign(key, std::move(one)); });
}

void merge(toml::table& below, toml::table& above, int levels) {
    for (auto&& [key, node] : above) {
        toml::table* here = below[key.str()].as_table();
        toml::table* there = node.as_table();
        if (levels > 0 && here != nullptr && there != nullptr && !is_whole(key.str()))
            merge(*here, *there, levels - 1);
        else
            put(below, key, node);
    }
}

}  // namespace

std::string laid_over(std::string_view below, std::string_view above, std::string_view above_source) {
    if (above.empty()) return std::string(below);
    return fmt::format("{}{}{}\n{}", below, kMark, above_source, above);
}

Layers layers_of(std::string_view toml) {
    const std::size_t mark = toml.find(kMark);
    if (mark == std::string_view::npos) return {toml, {}, ""};
    const std::size_t from = mark + kMark.size();
    const std::size_t end = std::min(toml.find('\n', from), toml.size());
    return {toml.substr(0, mark), toml.substr(std::min(end + 1, toml.size())),
            std::string(toml.substr(from, end - from))};
}

void lay_over(toml::table& below, toml::table above, const std::string& above_source, std::vector<Mistake>& mistakes) {
    std::vector<std::string> foreign;
    for (const auto& [key, node] : above) {
        const std::string name(key.str());
        if (std::ranges::find(kOfTheCurator, name) != kOfTheCurator.end()) continue;
        mistakes.push_back({above_source, static_cast<int>(node.source().begin.line),
                            name + " is not for the desk to say",
                            fmt::format("take it out; there are {}", fmt::join(kOfTheCurator, ", "))});
        foreign.push_back(name);
    }
    for (const std::string& name : foreign) above.erase(name);
    merge(below, above, 2);
}

}  // namespace quadrat::site
