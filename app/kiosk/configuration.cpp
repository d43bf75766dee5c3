// SPDX-License-Identifier: Apache-2.0
#include "kiosk/configuration.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <optional>
#include <stdexcept>

#include "base/error.hpp"
#include "base/text_file.hpp"
#include "genome/speech.hpp"
#include "kiosk/picture.hpp"

namespace quadrat::kiosk {
namespace {

constexpr std::array kDays{"monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday"};

// One reader for the whole file: it hands out values, remembers which keys were asked for, and refuses the others.
class Reader {
  public:
    Reader(const toml::table& root, const std::string& source) : root_(root), source_(source) {}

    void read(const char* table, const char* key, double& value, double low, double high) {
        if (const toml::node* node = find(table, key)) {
            const auto number = node->value<double>();
            if (!number || node->is_boolean()) refuse(*node, table, key, "is not a number");
            if (!(*number >= low && *number <= high))
                refuse(*node, table, key, fmt::format("is {}; it must lie between {} and {}", *number, low, high));
            value = *number;
        }
    }
    void read(const char* table, const char* key, int& value, int low, int high) {
        if (const toml::node* node = find(table, key)) {
            if (!node->is_integer()) refuse(*node, table, key, "is not a whole number");
            const auto number = *node->value<std::int64_t>();
            if (number < low || number > high)
                refuse(*node, table, key, fmt::format("is {}; it must lie between {} and {}", number, low, high));
            value = static_cast<int>(number);
        }
    }
    void read(const char* table, const char* key, bool& value) {
        if (const toml::node* node = find(table, key)) {
            if (!node->is_boolean()) refuse(*node, table, key, "is neither true nor false");
            value = *node->value<bool>();
        }
    }
    void read(const char* table, const char* key, std::string& value, const std::vector<std::string>& allowed = {}) {
        if (const toml::node* node = find(table, key)) value = string_in(*node, table, key, allowed);
    }
    void read(const char* table, const char* key, std::vector<std::string>& values,
              const std::vector<std::string>& allowed = {}) {
        const toml::node* node = find(table, key);
        if (node == nullptr) return;
        if (!node->is_array()) refuse(*node, table, key, "is not a list: write [\"…\", \"…\"]");
        values.clear();
        for (const toml::node& item : *node->as_array()) values.push_back(string_in(item, table, key, allowed));
    }

    void read_texts(std::map<std::string, std::string>& texts) {
        const toml::table* table = table_named("text");
        if (table == nullptr) return;
        for (const auto& [key, node] : *table) {
            const std::string name(key.str());
            if (std::ranges::find(genome::kPrompts, name) == genome::kPrompts.end())
                refuse_unknown(node, "text", name, {genome::kPrompts.begin(), genome::kPrompts.end()});
            texts[name] = string_in(node, "text", name.c_str(), {});
        }
    }

    void read_words(std::map<std::string, std::array<double, 2>>& words) {
        for (const genome::Word& word : genome::vocabulary()) {
            const std::string name(word.name);
            const toml::node* node = find("words", name.c_str());
            if (node == nullptr) continue;
            const toml::array* ends = node->as_array();
            const auto low = ends != nullptr && ends->size() == 2 ? (*ends)[0].value<double>() : std::nullopt;
            const auto high = low ? (*ends)[1].value<double>() : std::nullopt;
            if (!high || !(-1 <= *low && *low <= *high && *high <= 1))
                refuse(*node, "words", name.c_str(), "is not a range: write [LOW, HIGH], from -1 to 1");
            words[name] = {*low, *high};
        }
    }

    // A site that names any day is closed on those it does not name.
    void read_hours(staff::Hours& hours) {
        for (std::size_t day = 0; day < kDays.size(); ++day)
            if (const toml::node* node = find("hours", kDays[day])) {
                hours.is_always_open = false;
                hours.week[day] = spans_in(*node, "hours", kDays[day]);
            }
        const toml::node* exceptions = find("hours", "exceptions");
        if (exceptions == nullptr) return;
        if (!exceptions->is_table())
            refuse(*exceptions, "hours", "exceptions", "must be a table: write [hours.exceptions]");
        for (const auto& [key, node] : *exceptions->as_table()) {
            const std::string date(key.str());
            try {
                hours.exceptions[staff::parse_date(date)] = spans_in(node, "hours.exceptions", date.c_str());
            } catch (const std::invalid_argument& error) {
                refuse(node, "hours.exceptions", date.c_str(), error.what());
            }
        }
        if (hours.is_always_open && !hours.exceptions.empty()) {
            hours.is_always_open = false;
            hours.week.fill({{0, 24 * 60}});
        }
    }

    // Call last.
    void refuse_what_was_not_read() const {
        for (const auto& [name, node] : root_) {
            const std::string table(name.str());
            if (table == "text") continue;
            const auto known = known_.find(table);
            if (known == known_.end()) refuse_unknown(node, "", table, tables());
            if (!node.is_table())
                throw base::InputError(fmt::format("{}:{}: {} must be a table: write [{}]", source_,
                                                   node.source().begin.line, table, table));
            for (const auto& [key, value] : *node.as_table())
                if (std::ranges::find(known->second, std::string(key.str())) == known->second.end())
                    refuse_unknown(value, table, std::string(key.str()), known->second);
        }
    }

  private:
    std::vector<staff::OpenSpan> spans_in(const toml::node& node, const char* table, const char* key) const {
        const std::string text = string_in(node, table, key, {});
        try {
            return staff::parse_spans(text);
        } catch (const std::invalid_argument& error) {
            refuse(node, table, key, error.what());
        }
    }
    std::vector<std::string> tables() const {
        std::vector<std::string> names{"text"};
        for (const auto& [name, keys] : known_) names.push_back(name);
        return names;
    }
    const toml::table* table_named(const char* name) const {
        const toml::node* node = root_.get(name);
        if (node == nullptr) return nullptr;
        if (!node->is_table())
            throw base::InputError(
                fmt::format("{}:{}: {} must be a table: write [{}]", source_, node->source().begin.line, name, name));
        return node->as_table();
    }
    const toml::node* find(const char* table, const char* key) {
        known_[table].emplace_back(key);
        const toml::table* found = table_named(table);
        return found == nullptr ? nullptr : found->get(key);
    }
    std::string string_in(const toml::node& node, const char* table, const char* key,
                          const std::vector<std::string>& allowed) const {
        const auto text = node.value<std::string>();
        if (!node.is_string() || !text) refuse(node, table, key, "is not text in quotation marks");
        if (!allowed.empty() && std::ranges::find(allowed, *text) == allowed.end())
            refuse(node, table, key, fmt::format("is \"{}\"; it must be one of {}", *text, fmt::join(allowed, ", ")));
        return *text;
    }
    [[noreturn]] void refuse(const toml::node& node, const char* table, const char* key,
                             const std::string& what) const {
        throw base::InputError(fmt::format("{}:{}: {}.{} {}", source_, node.source().begin.line, table, key, what));
    }
    [[noreturn]] void refuse_unknown(const toml::node& node, const std::string& table, const std::string& key,
                                     const std::vector<std::string>& known) const {
        throw base::InputError(fmt::format("{}:{}: {}{}{} is not known; there are {}", source_,
                                           node.source().begin.line, table, table.empty() ? "" : ".", key,
                                           fmt::join(known, ", ")));
    }

    const toml::table& root_;
    const std::string& source_;
    std::map<std::string, std::vector<std::string>> known_;
};

void read_screen(Reader& reader, Configuration::Screen& screen) {
    reader.read("screen", "display", screen.display, {"auto", "kms", "window", "headless"});
    reader.read("screen", "size", screen.size);
    reader.read("screen", "connector", screen.connector);
    reader.read("screen", "mode", screen.mode);
    reader.read("screen", "rotation_deg", screen.rotation_deg, 0, 270);
    reader.read("screen", "mirrored", screen.is_mirrored);
}

void read_visit(Reader& reader, Configuration::Visit& visit) {
    reader.read("visit", "rounds", visit.rounds, 1, 50);
    reader.read("visit", "patience_s", visit.patience_s, 2, 600);
    reader.read("visit", "countdown_s", visit.countdown_s, 1, 120);
    reader.read("visit", "finale_s", visit.finale_s, 2, 600);
    reader.read("visit", "long_press_s", visit.long_press_s, 0.5, 30);
    reader.read("visit", "describe_words", visit.describe_words, 0, 10);
    reader.read("visit", "describe_every", visit.describe_every, 1, 1000);
    reader.read("visit", "describe_s", visit.describe_s, 2, 600);
    std::vector<std::string> spoken;
    for (const std::string_view code : genome::language_codes()) spoken.emplace_back(code);
    reader.read("visit", "language", visit.language, spoken);
}

void read_closing(Reader& reader, staff::DoorkeeperOptions& closing) {
    const auto seconds = [&](const char* key, std::chrono::seconds& value, int most) {
        int number = static_cast<int>(value.count());
        reader.read("hours", key, number, 0, most);
        value = std::chrono::seconds{number};
    };
    seconds("card_s", closing.card, 24 * 3600);
    seconds("overtime_s", closing.overtime, 4 * 3600);
    seconds("awake_s", closing.awake, 4 * 3600);
    reader.read("hours", "wakes_by_button", closing.wakes_by_button);
}

void read_breeding(Reader& reader, Configuration::Breeding& breeding) {
    reader.read("breeding", "genome", breeding.genome, {"words", "classic"});
    reader.read("breeding", "breeder", breeding.breeder, {"belief", "pbil", "pbil-gaussian", "random", "sliders"});
    reader.read("breeding", "learning_rate", breeding.learning_rate, 0, 1);
    reader.read("breeding", "mutation", breeding.mutation, 0, 1);
    reader.read("breeding", "mutation_form", breeding.mutation_form, {"toward-half", "random"});
    reader.read("breeding", "locked", breeding.locked, {"trees", "land", "sky"});
}

}  // namespace

Configuration configuration_from(std::string_view source_text, const std::string& source) {
    toml::table root;
    try {
        root = toml::parse(source_text, source);
    } catch (const toml::parse_error& error) {
        throw base::InputError(fmt::format("{}:{}:{}: {}", source, error.source().begin.line,
                                           error.source().begin.column, error.description()));
    }
    Configuration configuration;
    Reader reader(root, source);
    read_screen(reader, configuration.screen);
    reader.read("buttons", "inputs", configuration.inputs);
    read_visit(reader, configuration.visit);
    read_breeding(reader, configuration.breeding);
    reader.read_words(configuration.words);
    reader.read("picture", "alpha", configuration.picture.alpha, 0.05, 20);
    reader.read("picture", "samples", configuration.picture.samples, 1, 4);
    reader.read("picture", "land_samples", configuration.picture.land_samples, 65, 1025);
    reader.read("picture", "ground", configuration.picture.ground, ground_names());
    reader.read("fleet", "broker", configuration.fleet.broker);
    reader.read("fleet", "name", configuration.fleet.name);
    reader.read("fleet", "user", configuration.fleet.user);
    reader.read("fleet", "password_file", configuration.fleet.password_file);
    reader.read("fleet", "ca_file", configuration.fleet.ca_file);
    reader.read_hours(configuration.hours);
    read_closing(reader, configuration.closing);
    reader.read_texts(configuration.texts);
    reader.refuse_what_was_not_read();
    if (configuration.picture.samples != 1 && configuration.picture.samples != 4)
        throw base::InputError(
            fmt::format("{}: picture.samples is {}; it must be 1 or 4", source, configuration.picture.samples));
    const auto land = static_cast<unsigned>(configuration.picture.land_samples - 1);
    if (!std::has_single_bit(land))
        throw base::InputError(fmt::format("{}: picture.land_samples is {}; it must be 65, 129, 257, 513 or 1025",
                                           source, configuration.picture.land_samples));
    if (configuration.screen.rotation_deg % 90 != 0)
        throw base::InputError(fmt::format("{}: screen.rotation_deg is {}; it must be 0, 90, 180 or 270", source,
                                           configuration.screen.rotation_deg));
    return configuration;
}

Configuration read_configuration(const std::filesystem::path& path) {
    constexpr std::size_t kLargest = 1U << 20U;
    return configuration_from(base::read_text(path, {kLargest, kLargest}), path.string());
}

std::string text(const Configuration& configuration, const std::string& key) {
    assert(std::ranges::find(genome::kPrompts, key) != genome::kPrompts.end());
    if (const auto found = configuration.texts.find(key); found != configuration.texts.end()) return found->second;
    return std::string(genome::prompt(configuration.visit.language, key));
}

}  // namespace quadrat::kiosk
