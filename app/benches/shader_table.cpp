// SPDX-License-Identifier: Apache-2.0
#include "benches/shader_table.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "base/error.hpp"
#include "genome/json_text.hpp"

namespace quadrat::benches {
namespace {

using nlohmann::json;

// One object of the file, and how it is called in a message: "FILE: shaders[3]".
struct Place {
    const json& object;
    std::string name;

    [[noreturn]] void refuse(std::string_view key, const json& value, std::string_view right) const {
        throw base::InputError(fmt::format("{}: {} is {}; it should be {}", name, key, genome::brief(value), right));
    }
    std::string text(std::string_view key) const {
        const json& value = genome::member(object, key, name);
        if (!value.is_string() || value.get_ref<const std::string&>().empty()) refuse(key, value, "a text");
        return value.get<std::string>();
    }
    int count(std::string_view key) const {
        constexpr int kMost = 1'000'000;
        const json& value = genome::member(object, key, name);
        if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMost)
            refuse(key, value, fmt::format("a whole number from 0 to {}", kMost));
        return value.get<int>();
    }
    std::optional<int> count_or_null(std::string_view key) const {
        if (genome::member(object, key, name).is_null()) return std::nullopt;
        return count(key);
    }
    std::string stage(std::string_view key) const {
        std::string name_of_stage = text(key);
        if (name_of_stage != "fragment" && name_of_stage != "vertex" && name_of_stage != "binning")
            refuse(key, name_of_stage, "fragment, vertex or binning");
        return name_of_stage;
    }
};

CompiledShader shader_from(const json& row, std::string_view source, std::size_t number) {
    const std::string name = fmt::format("shaders[{}]", number);
    genome::require_object(
        row, {"vertex", "fragment", "stage", "chip", "instructions", "threads", "spills", "fills", "budget"}, source,
        name);
    const Place place{row, fmt::format("{}: {}", source, name)};
    return {place.text("vertex"),  place.text("fragment"),      place.stage("stage"),
            place.text("chip"),    place.count("instructions"), place.count("threads"),
            place.count("spills"), place.count("fills"),        place.count_or_null("budget")};
}

}  // namespace

ShaderTable shader_table_from(std::string_view text, std::string_view source) {
    const json whole = genome::parse_json(text, source);
    genome::require_object(whole, {"compiler", "shaders"}, source, "the table");
    const Place place{whole, std::string(source)};
    ShaderTable table{place.text("compiler"), {}};
    const json& rows = genome::member(whole, "shaders", source);
    if (!rows.is_array()) place.refuse("shaders", rows, "a list");
    std::set<std::tuple<std::string, std::string, std::string, std::string>> known;
    for (const json& row : rows) {
        CompiledShader shader = shader_from(row, source, table.shaders.size());
        if (!known.emplace(shader.vertex, shader.fragment, shader.stage, shader.chip).second)
            throw base::InputError(fmt::format("{}: shaders[{}] has the pair, stage and chip of a row before it",
                                               source, table.shaders.size()));
        table.shaders.push_back(std::move(shader));
    }
    return table;
}

bool has_few_threads(const CompiledShader& shader) {
    constexpr int kHideFetches = 4;
    return shader.stage == "fragment" && shader.threads < kHideFetches;
}

bool is_over_budget(const CompiledShader& shader) { return shader.budget && shader.instructions > *shader.budget; }

bool spills(const CompiledShader& shader) { return shader.spills + shader.fills > 0; }

}  // namespace quadrat::benches
