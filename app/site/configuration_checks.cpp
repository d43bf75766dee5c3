// SPDX-License-Identifier: Apache-2.0
#include "site/configuration_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mosquitto.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/listen_address.hpp"
#include "display/options.hpp"
#include "firmware-io/input_spec.hpp"
#include "firmware-io/scripted/scripted_buttons.hpp"
#include "genome/scene_code.hpp"
#include "genome/speech.hpp"
#include "projector/projector.hpp"
#include "site/broker_address.hpp"

namespace quadrat::site {
namespace {

namespace fs = std::filesystem;

// More would not fit on the card that is shown when the house is closed.
constexpr std::ptrdiff_t kLongestText = 160;
constexpr std::size_t kLongestName = 100;
constexpr const char* kFonts =
    "install a font that has them (Debian: fonts-noto-core, and fonts-droid-fallback for Chinese, Japanese and Korean)";

[[noreturn]] void refuse(const std::string& what) { throw base::InputError(what); }

bool is_control(char c) { return (static_cast<unsigned char>(c) < ' ' && c != '\n') || c == 127; }

void require_file(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) refuse(fmt::format("\"{}\": there is no such file; name one", path));
    if (status.type() == fs::file_type::directory) refuse(fmt::format("\"{}\" is a folder; name a file in it", path));
}

// Quotation marks are forgotten where a key has a dot: to TOML that is a table in a table.
void refuse_dotted(ConfigurationReader& reader, const toml::table& texts) {
    for (const std::string_view prompt : genome::kPrompts) {
        const std::string head(prompt.substr(0, prompt.find('.')));
        const toml::node* node = head.size() < prompt.size() ? texts.get(head) : nullptr;
        const toml::table* table = node != nullptr ? node->as_table() : nullptr;
        if (table == nullptr) continue;
        const toml::node* text = table->get(prompt.substr(head.size() + 1));
        if (text != nullptr)
            reader.refuse(*text, fmt::format("text.{}", prompt), "stands without quotation marks",
                          fmt::format("a key with a dot needs them: \"{}\" = \"…\"", prompt));
    }
}

bool is_language(std::string_view code) {
    const auto codes = genome::language_codes();
    return std::ranges::find(codes, code) != codes.end();
}

// Of a table that stands for forgotten quotation marks, what no prompt is called.
void refuse_unknown_dotted(ConfigurationReader& reader, const toml::table& texts) {
    for (const auto& [head, node] : texts) {
        if (!node.is_table() || is_language(head.str())) continue;
        for (const auto& [tail, text] : *node.as_table()) {
            const std::string name = fmt::format("{}.{}", head.str(), tail.str());
            const bool is_known = std::ranges::find(genome::kPrompts, name) != genome::kPrompts.end();
            if (!is_known)
                reader.refuse(
                    text, "text." + name, "is not known",
                    "write \"ask.trees\", \"ask.land\", \"ask.sky\" or \"describe.trees\" …, in quotation marks");
        }
        reader.pass_over("text", std::string(head.str()));  // all that is to be said of it is said here
    }
}

}  // namespace

void check_size(const std::string& text) {
    if (!text.empty()) display::size_from(text, "");
}

void check_mode(const std::string& text) { display::mode_from(text, ""); }

void check_connector(const std::string& text) {
    // As the kernel's drm_connector.c calls them.
    constexpr std::array<std::string_view, 19> kKinds{
        "HDMI-A", "HDMI-B", "DP",        "eDP",    "DVI-I", "DVI-D",     "DVI-A",   "VGA", "DSI", "DPI",
        "LVDS",   "TV",     "Composite", "SVIDEO", "DIN",   "Component", "Virtual", "SPI", "USB"};
    const std::size_t dash = text.rfind('-');
    const std::string number = dash == std::string::npos ? "" : text.substr(dash + 1);
    const bool is_number = !number.empty() && number.size() <= 3 && number.front() != '0' &&
                           number.find_first_not_of("0123456789") == std::string::npos;
    const bool is_kind = std::ranges::find(kKinds, std::string_view(text).substr(0, dash)) != kKinds.end();
    if (!text.empty() && !(is_number && is_kind))
        refuse(fmt::format(": \"{}\" is no connector; write one such as HDMI-A-1 or DP-2 (ls /sys/class/drm)", text));
}

void InputCheck::operator()(const std::string& spec) {
    const firmware_io::InputSpec parsed = firmware_io::parse_input_spec(spec);
    if (const auto* script = std::get_if<firmware_io::ScriptSpec>(&parsed)) {
        require_file(script->file);
        firmware_io::scripted::read_script(script->file);
    }
    const auto* wiring = std::get_if<firmware_io::gpio::Wiring>(&parsed);
    if (wiring == nullptr) return;
    const std::size_t before = lines_.size();
    for (const auto* wires : {&wiring->contacts, &wiring->lamps})
        for (const firmware_io::gpio::Wire& wire : *wires) {
            const auto end = lines_.begin() + static_cast<std::ptrdiff_t>(before);
            if (std::find(lines_.begin(), end, wire.line) != end)
                refuse(
                    fmt::format("line {} is in two inputs; give each button a line of its own", to_string(wire.line)));
            lines_.push_back(wire.line);
        }
}

void check_power(const std::string& address) {
    if (!address.empty()) projector::parse_address(address);
}

void check_broker(const std::string& address) {
    if (!address.empty()) parse_broker(address);
}

void check_listen_address(const std::string& text) {
    if (text.empty()) return;
    try {
        base::parse_listen_address(text);
    } catch (const std::invalid_argument& error) {
        refuse(fmt::format("is \"{}\": {}", text, error.what()));
    }
}

// What comes after it is letters and digits, so it may end in anything that may stand before them.
void check_take_home(const std::string& url) {
    constexpr std::size_t kLongest = 120;  // with the code it still is a code that telephones read from the screen
    if (url.empty()) return;
    const std::size_t host = url.starts_with("https://") ? 8 : url.starts_with("http://") ? 7 : 0;
    const bool has_host = host > 0 && host < url.size() && url[host] != '/';
    const bool is_plain = std::ranges::all_of(url, [](char c) {
        return c > ' ' && c < 127 && std::string_view("\"<>\\^`{|}").find(c) == std::string_view::npos;
    });
    if (!has_host || !is_plain)
        refuse(fmt::format("is \"{}\"; write an address such as https://museum.example/quadrat/, in ASCII", url));
    if (url.size() > kLongest)
        refuse(fmt::format("has {} letters; with more than {} the code would be too fine to be read", url.size(),
                           kLongest));
}

void check_fleet_name(const std::string& name) {
    const std::string topic = "quadrat/" + name + "/status";
    const bool is_word = name.find_first_of("/+#") == std::string::npos && name.size() <= kLongestName &&
                         mosquitto_pub_topic_check(topic.c_str()) == MOSQ_ERR_SUCCESS &&
                         std::ranges::none_of(name, is_control) && name.find('\n') == std::string::npos;
    const bool is_blank = !name.empty() && name.find_first_not_of(' ') == std::string::npos;
    if (!is_word || is_blank)
        refuse(fmt::format("is \"{}\"; it must be a word without / + and #, of {} bytes at most", name, kLongestName));
}

void check_fleet_user(const std::string& name) {
    if (std::ranges::any_of(name, is_control) || name.size() > kLongestName)
        refuse(fmt::format("is no name; write one of {} bytes at most, on one line", kLongestName));
}

void check_folder(const std::string& path) {
    std::error_code error;
    if (!path.empty() && !std::filesystem::is_directory(path, error))
        refuse(fmt::format("names no folder that is there: {}; make it, or name another", path));
}

void check_sound_device(const std::string& name) {
    constexpr std::size_t kLongest = 200;
    const bool is_plain = std::ranges::all_of(name, [](char c) { return c > ' ' && c < 127; });
    if (!is_plain || name.size() > kLongest) refuse("is no name of a sound card; take one that aplay -L lists");
}

void check_words(const std::string& words, const LettersWithoutFont& without_font) {
    const auto letters =
        std::ranges::count_if(words, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; });
    if (letters > kLongestText)
        refuse(fmt::format("has {} letters; the screen has room for {}", letters, kLongestText));
    if (std::ranges::any_of(words, is_control)) refuse("has control characters; write letters alone");
    if (const std::string missing = without_font(words); !missing.empty())
        refuse(fmt::format("no installed font has the letters {}; {}", missing, kFonts));
}

void check_printer(const std::string& name) {
    constexpr std::size_t kLongest = 127;  // CUPS's
    const bool is_plain = std::ranges::all_of(
        name, [](char c) { return c > ' ' && c < 127 && c != '/' && c != '#' && c != '\'' && c != '"'; });
    if (!is_plain || name.size() > kLongest || name.starts_with('-'))
        refuse("is no name of a printer; take one that lpstat -e lists");
}

void check_code(const std::string& code) {
    try {
        genome::recipe_of_code(code, "a code");
    } catch (const base::InputError& error) {
        refuse(fmt::format("holds what is no landscape ({}); quadrat code tells a landscape's", error.what()));
    }
}

void check_topic_prefix(const std::string& prefix) {
    if (prefix.empty()) return;
    if (prefix.size() > kLongestName || prefix.front() == '/' || prefix.front() == '$' || prefix.back() == '/' ||
        std::ranges::any_of(prefix, is_control) || mosquitto_pub_topic_check(prefix.c_str()) != MOSQ_ERR_SUCCESS)
        refuse(fmt::format("is \"{}\"; it must be a topic without + and #, as homeassistant", prefix));
}

void check_file(const std::string& path) {
    if (!path.empty()) require_file(path);
}

void read_texts_in(ConfigurationReader& reader, const toml::table& table, const std::string& name,
                   TextsByLanguage& texts, const LettersWithoutFont& without_font) {
    const auto check = [&](const std::string& words) { check_words(words, without_font); };
    for (const auto& [key, node] : table) {
        const std::string prompt(key.str());
        const std::string full = fmt::format("{}.{}", name, prompt);
        const std::string code = name.substr(name.rfind('.') + 1);
        std::string words;
        if (std::ranges::find(genome::kPrompts, prompt) == genome::kPrompts.end())
            reader.refuse(node, full, "is not known", fmt::format("there are {}", fmt::join(genome::kPrompts, ", ")));
        else if (reader.read_text(node, full, words, check))
            texts[code][prompt] = words;
    }
}

void read_texts(ConfigurationReader& reader, Configuration& configuration, const LettersWithoutFont& without_font) {
    const auto check = [&](const std::string& words) { check_words(words, without_font); };
    for (const std::string_view prompt : genome::kPrompts) {
        const std::string key(prompt);
        std::string words;
        const toml::node* node = reader.find("text", key.c_str());
        if (node != nullptr && reader.read_text(*node, "text." + key, words, check)) configuration.texts[key] = words;
    }
    const toml::table* table = reader.find_table("text");
    if (table == nullptr) return;
    for (const auto& [code, node] : *table) {
        if (!node.is_table() || !is_language(code.str())) continue;
        reader.pass_over("text", std::string(code.str()));
        read_texts_in(reader, *node.as_table(), fmt::format("text.{}", code.str()), configuration.texts_in,
                      without_font);
    }
    refuse_dotted(reader, *table);
    refuse_unknown_dotted(reader, *table);
}

void check_zone(const std::string& name) {
    if (name.empty()) return;
    const bool is_plain = std::ranges::all_of(name, [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '/' || c == '_' ||
               c == '-' || c == '+';
    });
    std::error_code error;
    if (!is_plain || name.front() == '/' || !fs::is_regular_file(fs::path("/usr/share/zoneinfo") / name, error))
        refuse(fmt::format("is \"{}\"; write one that the machine knows, as Europe/Berlin (timedatectl list-timezones)",
                           name));
}

void check_language(ConfigurationReader& reader, const Configuration& configuration,
                    const LettersWithoutFont& without_font) {
    if (const toml::node* offered = reader.find("visit", "languages"); offered != nullptr) {
        for (const std::string& code : configuration.visit.languages) {
            std::string spoken;
            for (const std::string_view prompt : genome::kPrompts)
                spoken.append(genome::prompt(code, prompt)).append("\n");
            if (const std::string missing = without_font(spoken); !missing.empty())
                reader.refuse(*offered, "visit.languages",
                              fmt::format("has \"{}\"; no installed font has its letters {}", code, missing), kFonts);
        }
    }
    const toml::node* node = reader.find("visit", "language");
    const bool is_spoken = node != nullptr && node->value<std::string>() == configuration.visit.language;
    const std::string missing = is_spoken ? letters_missing_for(configuration, without_font) : "";
    if (!missing.empty())
        reader.refuse(
            *node, "visit.language",
            fmt::format("is \"{}\"; no installed font has its letters {}", configuration.visit.language, missing),
            kFonts);
}

std::string letters_missing_for(const Configuration& configuration, const LettersWithoutFont& without_font) {
    std::string spoken;
    const auto own = configuration.texts_in.find(configuration.visit.language);
    const auto has_own = [&](const std::string& key) {
        return configuration.texts.contains(key) || (own != configuration.texts_in.end() && own->second.contains(key));
    };
    for (const std::string_view prompt : genome::kPrompts)
        if (!has_own(std::string(prompt)))
            spoken.append(genome::prompt(configuration.visit.language, prompt)).append("\n");
    return without_font(spoken);
}

}  // namespace quadrat::site
