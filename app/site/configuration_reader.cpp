// SPDX-License-Identifier: Apache-2.0
#include "site/configuration_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace quadrat::site {
namespace {

std::string full_name(const std::string& table, const std::string& key) { return table + "." + key; }

// A sentence about `name` from one that names it already, or tells only what is wrong with it.
std::string of(const std::string& name, const std::string& said) {
    if (said.starts_with(name)) return said;
    if (said.starts_with(':')) return name + said;
    const bool is_predicate = said.starts_with("is ") || said.starts_with("has ");
    return name + (is_predicate ? " " : ": ") + said;
}

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

ConfigurationReader::Check one_of(const ConfigurationReader::Names& allowed) {
    return [&allowed](const std::string& text) {
        if (!allowed.empty() && std::ranges::find(allowed, text) == allowed.end())
            throw base::InputError(fmt::format("is \"{}\"; it must be one of {}", text, fmt::join(allowed, ", ")));
    };
}

}  // namespace

const std::string& ConfigurationReader::source_of(const toml::node& node) const {
    return node.source().path ? *node.source().path : source_;
}

void ConfigurationReader::refuse(const toml::node& node, const std::string& name, const std::string& what,
                                 const std::string& remedy) {
    mistakes_.push_back({source_of(node), line_of(node), name + " " + what, remedy});
}

void ConfigurationReader::refuse_unknown(const toml::node& node, const std::string& name, const Names& known) {
    refuse(node, name, "is not known", fmt::format("there are {}", fmt::join(known, ", ")));
}

const toml::table* ConfigurationReader::find_table(const char* table) {
    known_.try_emplace(table);
    const toml::node* node = root_.get(table);
    return node == nullptr ? nullptr : node->as_table();
}

const toml::node* ConfigurationReader::find(const char* table, const char* key) {
    const toml::table* found = find_table(table);
    Names& known = known_[table];
    if (std::ranges::find(known, key) == known.end()) known.emplace_back(key);
    return found == nullptr ? nullptr : found->get(key);
}

bool ConfigurationReader::read_text(const toml::node& node, const std::string& name, std::string& text,
                                    const Check& check) {
    if (!node.is_string()) {
        refuse(node, name, "is not text in quotation marks", "write \"…\"");
        return false;
    }
    std::string read = *node.value<std::string>();
    try {
        check(read);
    } catch (const std::exception& error) {
        mistakes_.push_back(mistake_from(source_of(node), line_of(node), of(name, error.what())));
        return false;
    }
    text = std::move(read);
    return true;
}

void ConfigurationReader::read(const char* table, const char* key, double& value, double low, double high) {
    const toml::node* node = find(table, key);
    if (node == nullptr) return;
    const auto number = node->is_number() ? node->value<double>() : std::nullopt;
    const std::string remedy = fmt::format("it must lie between {} and {}", low, high);
    if (!number)
        refuse(*node, full_name(table, key), "is not a number", remedy);
    else if (!(*number >= low && *number <= high))
        refuse(*node, full_name(table, key), fmt::format("is {}", *number), remedy);
    else
        value = *number;
}

void ConfigurationReader::read(const char* table, const char* key, int& value, int low, int high) {
    const toml::node* node = find(table, key);
    if (node == nullptr) return;
    const auto number = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
    const std::string remedy = fmt::format("it must lie between {} and {}", low, high);
    if (!number)
        refuse(*node, full_name(table, key), "is not a whole number", remedy);
    else if (*number < low || *number > high)
        refuse(*node, full_name(table, key), fmt::format("is {}", *number), remedy);
    else
        value = static_cast<int>(*number);
}

void ConfigurationReader::read_one_of(const char* table, const char* key, int& value, const std::vector<int>& allowed) {
    const toml::node* node = find(table, key);
    if (node == nullptr) return;
    const auto number = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
    const std::vector<int> all_but_last(allowed.begin(), allowed.end() - 1);
    const std::string remedy = fmt::format("it must be {} or {}", fmt::join(all_but_last, ", "), allowed.back());
    if (!number)
        refuse(*node, full_name(table, key), "is not a whole number", remedy);
    else if (std::ranges::find(allowed, *number) == allowed.end())
        refuse(*node, full_name(table, key), fmt::format("is {}", *number), remedy);
    else
        value = static_cast<int>(*number);
}

void ConfigurationReader::read(const char* table, const char* key, bool& value) {
    const toml::node* node = find(table, key);
    if (node == nullptr) return;
    if (node->is_boolean())
        value = *node->value<bool>();
    else
        refuse(*node, full_name(table, key), "is neither true nor false", "write true or false");
}

void ConfigurationReader::read(const char* table, const char* key, std::string& value, const Names& allowed) {
    read_checked(table, key, value, one_of(allowed));
}

void ConfigurationReader::read(const char* table, const char* key, std::vector<std::string>& values,
                               const Names& allowed) {
    read_checked(table, key, values, one_of(allowed));
}

void ConfigurationReader::read_checked(const char* table, const char* key, std::string& value, const Check& check) {
    if (const toml::node* node = find(table, key)) read_text(*node, full_name(table, key), value, check);
}

void ConfigurationReader::read_checked(const char* table, const char* key, std::vector<std::string>& values,
                                       const Check& check) {
    const toml::node* node = find(table, key);
    if (node == nullptr) return;
    if (!node->is_array()) return refuse(*node, full_name(table, key), "is not a list", "write [\"…\", \"…\"]");
    std::vector<std::string> read;
    bool are_right = true;
    for (const toml::node& item : *node->as_array()) {
        const bool is_right = read_text(item, full_name(table, key), read.emplace_back(), check);
        are_right = are_right && is_right;
        const bool is_again = is_right && std::find(read.begin(), read.end() - 1, read.back()) != read.end() - 1;
        if (!is_again) continue;
        refuse(item, full_name(table, key), fmt::format("names \"{}\" twice", read.back()), "name it once");
        are_right = false;
    }
    if (are_right) values = std::move(read);
}

ConfigurationReader::Names ConfigurationReader::tables() const {
    Names names;
    for (const auto& [name, keys] : known_) names.push_back(name);
    return names;
}

void ConfigurationReader::refuse_what_was_not_read() {
    for (const auto& [name, node] : root_) {
        const std::string table(name.str());
        const auto known = known_.find(table);
        if (known == known_.end()) {
            refuse_unknown(node, table, tables());
        } else if (!node.is_table()) {
            refuse(node, table, "must be a table", fmt::format("write [{}]", table));
        } else {
            for (const auto& [key, value] : *node.as_table()) {
                const std::string full = full_name(table, std::string(key.str()));
                const bool is_known = std::ranges::find(known->second, std::string(key.str())) != known->second.end();
                if (!is_known && !passed_over_.contains(full)) refuse_unknown(value, full, known->second);
            }
        }
    }
    std::ranges::stable_sort(mistakes_, {}, &Mistake::line);
}

}  // namespace quadrat::site
