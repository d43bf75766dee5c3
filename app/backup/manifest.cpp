// SPDX-License-Identifier: Apache-2.0
#include "backup/manifest.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "backup/tar.hpp"
#include "base/error.hpp"

namespace quadrat::backup {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kVersion = 1;
constexpr std::size_t kLargestManifest = std::size_t{1} << 20U;

[[noreturn]] void refuse(const std::string& source, const std::string& what) {
    throw base::InputError(fmt::format("{}: {}", source, what));
}

// Where a position lies among the bytes. Columns count letters, a line begins with the first.
std::size_t byte_at(const std::string& text, const toml::source_position& position) {
    std::size_t at = 0;
    for (toml::source_index line = 1; line < position.line && at != std::string::npos; ++line)
        at = text.find('\n', at) == std::string::npos ? text.size() : text.find('\n', at) + 1;
    for (toml::source_index column = 1; column < position.column && at < text.size(); ++column)
        for (++at; at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U;) ++at;
    return at;
}

}  // namespace

std::string to_json(const Manifest& manifest) {
    return json{{"quadrat", "backup"},   {"version", kVersion},         {"program", manifest.program},
                {"host", manifest.host}, {"made_at", manifest.made_at}, {"files", manifest.files}}
               .dump(1, ' ', false, json::error_handler_t::replace) +
           "\n";
}

Manifest manifest_from(std::string_view text, const std::string& source) {
    const json read = json::parse(text, nullptr, false);
    if (!read.is_object() || read.value("quadrat", json()) != "backup") refuse(source, "is not a backup of Quadrat");
    const json version = read.value("version", json());
    if (version.is_number_integer() && version > kVersion)
        refuse(source,
               fmt::format("a newer program made it ({}): install that, or a newer one; this one reads version {}",
                           read.value("program", json()).dump(), kVersion));
    try {
        if (version != kVersion) refuse(source, "says nothing of its version");
        return {read.at("program"), read.at("host"), read.at("made_at"), read.at("files")};
    } catch (const json::exception& error) {
        refuse(source, fmt::format("its {} is damaged: {}", kManifest, error.what()));
    }
}

Manifest manifest_of(const fs::path& backup) {
    TarReader tar(backup);
    const auto first = tar.next();
    if (!first || first->name != kManifest || !first->is_file) refuse(backup.string(), "is not a backup of Quadrat");
    return manifest_from(tar.bytes(kLargestManifest), backup.string());
}

std::vector<fs::path> files_named_in(const site::Configuration& configuration) {
    std::vector<fs::path> files;
    for (const std::string& file :
         {configuration.screen.power_password_file, configuration.fleet.password_file, configuration.fleet.ca_file,
          configuration.desk.certificate, configuration.desk.key})
        if (!file.empty()) files.emplace_back(file);
    for (const std::string& input : configuration.inputs) {
        if (input.starts_with("script:")) files.emplace_back(input.substr(7));
        std::istringstream parts(input.substr(input.find(':') + 1));
        for (std::string part; std::getline(parts, part, ',');)
            if (part.starts_with("map=")) files.emplace_back(part.substr(4));
    }
    return files;
}

std::string without_fleet_name(const std::string& text, const std::string& source) {
    const toml::table table = toml::parse(text, source);
    const toml::node* name = table["fleet"]["name"].node();
    if (name == nullptr || table["fleet"]["name"].value_or(std::string{}).empty()) return text;
    const std::size_t from = byte_at(text, name->source().begin);
    const std::size_t until = byte_at(text, name->source().end);
    std::string changed = text;
    changed.replace(from, until - from, "\"\"");
    toml::table wanted = table;
    wanted["fleet"].as_table()->insert_or_assign("name", "");
    try {
        if (toml::parse(changed) == wanted) return changed;
    } catch (const toml::parse_error&) {
        // as below
    }
    refuse(source,
           fmt::format("line {}: fleet.name cannot be taken out: empty it by hand in the settings, and make the "
                       "backup again",
                       name->source().begin.line));
}

}  // namespace quadrat::backup
