// SPDX-License-Identifier: Apache-2.0
#include "site/configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text_file.hpp"
#include "genome/speech.hpp"
#include "render/ground_by.hpp"
#include "site/configuration_checks.hpp"
#include "site/configuration_reader.hpp"
#include "site/layers.hpp"
#include "site/themes_reader.hpp"

namespace quadrat::site {
namespace {

using Reader = ConfigurationReader;

constexpr std::array kDays{"monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday"};

void read_screen(Reader& reader, Configuration::Screen& screen) {
    reader.read("screen", "display", screen.display, {"auto", "kms", "window", "headless"});
    reader.read_checked("screen", "size", screen.size, check_size);
    reader.read_checked("screen", "connector", screen.connector, check_connector);
    reader.read_checked("screen", "mode", screen.mode, check_mode);
    reader.read_one_of("screen", "rotation_deg", screen.rotation_deg, {0, 90, 180, 270});
    reader.read("screen", "mirrored", screen.is_mirrored);
    reader.read_checked("screen", "power", screen.power, check_power);
    reader.read_checked("screen", "power_password_file", screen.power_password_file, check_file);
}

void read_visit(Reader& reader, Configuration::Visit& visit) {
    reader.read("visit", "rounds", visit.rounds, 1, 50);
    reader.read("visit", "rounds_early", visit.rounds_early, 0, 10);
    reader.read("visit", "rounds_more", visit.rounds_more, 0, 10);
    reader.read("visit", "turns", visit.turns, {"found", "always", "never"});
    reader.read("visit", "family", visit.shows_family);
    reader.read("visit", "patience_s", visit.patience_s, 2, 600);
    reader.read("visit", "countdown_s", visit.countdown_s, 1, 120);
    reader.read("visit", "finale_s", visit.finale_s, 2, 600);
    reader.read("visit", "long_press_s", visit.long_press_s, 0.5, 30);
    reader.read("visit", "describe_words", visit.describe_words, 0, 10);
    reader.read("visit", "describe_every", visit.describe_every, 1, 1000);
    reader.read("visit", "describe_others", visit.describe_others);
    reader.read("visit", "describe_s", visit.describe_s, 2, 600);
    reader.read_checked("visit", "language_folder", visit.language_folder, [](const std::string& folder) {
        if (!folder.empty()) genome::speak_from_folder(folder);
    });
    std::vector<std::string> spoken;
    for (const std::string_view code : genome::language_codes()) spoken.emplace_back(code);
    reader.read("visit", "language", visit.language, spoken);
    reader.read("visit", "languages", visit.languages, spoken);
}

void read_sound(Reader& reader, Configuration::Sound& sound) {
    reader.read("sound", "on", sound.is_on);
    reader.read("sound", "level", sound.level, 0, 1);
    reader.read("sound", "soundscape", sound.soundscape, 0, 1);
    reader.read("sound", "signals", sound.signals, 0, 1);
    reader.read("sound", "speech", sound.speaks);
    reader.read_checked("sound", "speech_folder", sound.speech_folder, check_folder);
    reader.read_checked("sound", "device", sound.device, check_sound_device);
    reader.read_checked("sound", "private_device", sound.private_device, check_sound_device);
    reader.read("sound", "private_level", sound.private_level, 0, 1);
    const toml::node* node = reader.find("sound", "private_device");
    if (node == nullptr || sound.private_device.empty()) return;
    if (sound.private_device == sound.device)
        reader.refuse(*node, "sound.private_device", "is the same card as sound.device", "name another: aplay -L");
    else if (!sound.speaks)
        reader.refuse(*node, "sound.private_device", "is there, and nobody speaks on it", "add speech = true");
}

// A time that 0 switches off, and that makes no sense when it is shorter than a hand.
void read_or_never(Reader& reader, const char* key, double& value, double low, double high) {
    reader.read("play", key, value, 0, high);
    const toml::node* node = reader.find("play", key);
    if (value == 0 || value >= low || node == nullptr) return;
    reader.refuse(*node, std::string("play.") + key, fmt::format("is {}", value),
                  fmt::format("it must be 0, or lie between {} and {}", low, high));
    value = 0;
}

void read_play(Reader& reader, Configuration& configuration) {
    Configuration::Play& play = configuration.play;
    reader.read("play", "buttons", play.buttons, {"four", "two", "one"});
    reader.read("play", "held", play.held, {"one", "two"});
    read_or_never(reader, "hold_s", play.hold_s, 1, 9);  // longer is leaning on it
    reader.read("play", "pace_s", play.pace_s, 0.3, 30);
    reader.read("play", "times_round", play.times_round, 0, 100);
    reader.read("play", "begins_by_itself", play.begins_by_itself);
    read_or_never(reader, "dwell_s", play.dwell_s, 0.5, 30);
    reader.read("play", "quiet_s", play.quiet_s, 0, 5);
    reader.read("play", "patience", play.patience, 1, 20);
    reader.read("play", "shows_how", play.shows_how);
    // A, B, C, D and Back, and the first of them longer: whoever waits for the last one must not be asked whether they
    // are there.
    constexpr double kPaces = 5.5;
    const double patience_s = play.patience * std::min(configuration.visit.patience_s, configuration.visit.describe_s);
    const toml::node* node = reader.find("play", "pace_s");
    if (node != nullptr && kPaces * play.pace_s > patience_s)
        reader.refuse(*node, "play.pace_s",
                      fmt::format("is {}, so the mark takes {} s to go round, and the visit waits {} s", play.pace_s,
                                  kPaces * play.pace_s, patience_s),
                      "make it smaller, or raise play.patience, visit.patience_s and visit.describe_s");
}

void read_closing(Reader& reader, DoorkeeperOptions& closing) {
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
    reader.read("breeding", "learns_taste", breeding.learns_taste);
    reader.read("breeding", "learning_rate", breeding.learning_rate, 0, 1);
    reader.read("breeding", "mutation", breeding.mutation, 0, 1);
    reader.read("breeding", "mutation_form", breeding.mutation_form, {"toward-half", "random"});
    reader.read("breeding", "locked", breeding.locked, {"trees", "land", "sky"});
    reader.read("breeding", "control_every", breeding.control_every, 0, 1000);
}

void read_picture(Reader& reader, Configuration::Picture& picture) {
    reader.read("picture", "alpha", picture.alpha, 0.05, 20);
    reader.read_one_of("picture", "samples", picture.samples, {1, 4});
    reader.read_one_of("picture", "land_samples", picture.land_samples, {65, 129, 257, 513, 1025});
    reader.read("picture", "ground", picture.ground, render::ground_names());
}

// They stand beside what they are about: words under [text], pictures under [picture].
void read_look(Reader& reader, Configuration::Look& look) {
    reader.read("text", "size", look.size, {"normal", "large", "largest"});
    reader.read("text", "contrast", look.contrast, {"normal", "high"});
    reader.read("picture", "motion", look.motion, {"full", "calm"});
    reader.read("text", "pictograms", look.pictograms, {"beside", "alone", "none"});
}

void read_attract(Reader& reader, Configuration::Attract& attract) {
    const auto read = [&](const char* key, std::vector<std::string>& codes, std::size_t most) {
        reader.read_checked("attract", key, codes, [&, count = std::size_t{0}](const std::string& code) mutable {
            check_code(code);
            if (++count > most) throw std::invalid_argument(fmt::format("has more than {} landscapes", most));
        });
    };
    read("favourites", attract.favourites, Configuration::Attract::kMostFavourites);
    read("hidden", attract.hidden, Configuration::Attract::kMostHidden);
    reader.read("attract", "breed_on", attract.breeds_on);
    reader.read("attract", "year", attract.has_year);
}

void read_postcard(Reader& reader, Configuration::Postcard& postcard, const LettersWithoutFont& without_font) {
    reader.read_checked("postcard", "printer", postcard.printer, check_printer);
    reader.read("postcard", "when", postcard.when, {"asked", "always"});
    reader.read_checked("postcard", "place", postcard.place, [&](const std::string& place) {
        if (!place.empty()) check_words(place, without_font);
    });
}

void read_fleet(Reader& reader, Configuration::Fleet& fleet) {
    reader.read_checked("fleet", "broker", fleet.broker, check_broker);
    reader.read_checked("fleet", "name", fleet.name, check_fleet_name);
    reader.read_checked("fleet", "user", fleet.user, check_fleet_user);
    reader.read_checked("fleet", "password_file", fleet.password_file, check_file);
    reader.read_checked("fleet", "ca_file", fleet.ca_file, check_file);
    reader.read("fleet", "orders", fleet.takes_orders);
    reader.read_checked("fleet", "discovery", fleet.discovery, check_topic_prefix);
    reader.read("fleet", "shares", fleet.shares, {"nothing", "favourites", "bred"});
    reader.read("fleet", "takes", fleet.takes, {"nothing", "chosen", "all"});
}

void read_desk(Reader& reader, Configuration::Desk& desk) {
    reader.read_checked("desk", "listen", desk.listen, check_listen_address);
    reader.read_checked("desk", "certificate", desk.certificate, check_file);
    reader.read_checked("desk", "key", desk.key, check_file);
}

void read_spans(Reader& reader, const toml::node& node, const std::string& name, std::vector<OpenSpan>& spans) {
    std::string text;
    if (reader.read_text(node, name, text, [](const std::string& said) { parse_spans(said); }))
        spans = parse_spans(text);
}

void read_exceptions(Reader& reader, Hours& hours) {
    const toml::node* node = reader.find("hours", "exceptions");
    if (node == nullptr) return;
    if (!node->is_table())
        return reader.refuse(*node, "hours.exceptions", "must be a table", "write [hours.exceptions]");
    for (const auto& [key, value] : *node->as_table()) {
        const std::string date(key.str());
        try {
            read_spans(reader, value, "hours.exceptions." + date, hours.exceptions[parse_date(date)]);
        } catch (const std::invalid_argument&) {
            reader.refuse(value, "hours.exceptions." + date, "is no date", "write 2026-12-24");
        }
    }
}

// A site that names any day is closed on those it does not name.
void read_hours(Reader& reader, Hours& hours) {
    for (std::size_t day = 0; day < kDays.size(); ++day)
        if (const toml::node* node = reader.find("hours", kDays[day])) {
            hours.is_always_open = false;
            read_spans(reader, *node, std::string("hours.") + kDays[day], hours.week[day]);
        }
    read_exceptions(reader, hours);
    if (hours.is_always_open && !hours.exceptions.empty()) {
        hours.is_always_open = false;
        hours.week.fill({{0, 24 * 60}});
    }
}

void read_all(Reader& reader, Configuration& configuration, const LettersWithoutFont& without_font) {
    read_screen(reader, configuration.screen);
    reader.read_checked("buttons", "inputs", configuration.inputs, InputCheck{});
    read_visit(reader, configuration.visit);
    read_play(reader, configuration);
    read_sound(reader, configuration.sound);
    read_breeding(reader, configuration.breeding);
    read_words(reader, configuration.words);
    read_picture(reader, configuration.picture);
    read_look(reader, configuration.look);
    reader.read_checked("take_home", "url", configuration.take_home.url, check_take_home);
    read_postcard(reader, configuration.postcard, without_font);
    read_attract(reader, configuration.attract);
    read_fleet(reader, configuration.fleet);
    read_desk(reader, configuration.desk);
    read_hours(reader, configuration.hours);
    reader.read_checked("hours", "zone", configuration.zone, check_zone);
    read_closing(reader, configuration.closing);
    read_texts(reader, configuration, without_font);
    read_themes(reader, configuration, without_font);
    check_language(reader, configuration, without_font);
    reader.refuse_what_was_not_read();
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

CheckedConfiguration unusable(const std::string& source, std::string_view message) {
    const std::string prefix = source + ": ";
    return {{}, {mistake_from(source, 0, message.substr(message.starts_with(prefix) ? prefix.size() : 0))}};
}

void read_into(CheckedConfiguration& checked, const toml::table& root, const std::string& source,
               const LettersWithoutFont& without_font) {
    Reader reader(root, source);
    read_all(reader, checked.configuration, without_font);
    checked.mistakes.insert(checked.mistakes.end(), reader.mistakes().begin(), reader.mistakes().end());
    for (Mistake& mistake : checked.mistakes) mistake = on_one_line(std::move(mistake));
    std::ranges::stable_sort(checked.mistakes, {}, &Mistake::line);
}

CheckedConfiguration check_layer(std::string_view toml, const std::string& source,
                                 const LettersWithoutFont& without_font) {
    if (is_blank(toml))
        return unusable(source,
                        "the file is empty, as a pulled plug leaves one; put the settings back, or a line that begins "
                        "with # to have the defaults");
    if (const std::string trouble = base::trouble_of_encoding(toml); !trouble.empty()) return unusable(source, trouble);
    ParsedToml parsed = parse_toml(toml, source);
    CheckedConfiguration checked;
    checked.mistakes = std::move(parsed.mistakes);
    const toml::table nothing;
    read_into(checked, parsed.is_whole ? parsed.root : nothing, source, without_font);
    return checked;
}

Configuration required(CheckedConfiguration checked) {
    if (!checked.is_usable()) throw SettingsError(std::move(checked.mistakes));
    return std::move(checked.configuration);
}

}  // namespace

CheckedConfiguration check_configuration(std::string_view toml, const std::string& source,
                                         const LettersWithoutFont& without_font) {
    const Layers layers = layers_of(toml);
    CheckedConfiguration checked = check_layer(layers.below, source, without_font);
    if (layers.above.empty() || !checked.is_usable()) return checked;
    CheckedConfiguration both;
    ParsedToml below = parse_toml(layers.below, source);
    if (const std::string trouble = base::trouble_of_encoding(layers.above); !trouble.empty()) {
        both.mistakes = unusable(layers.above_source, trouble).mistakes;
    } else {
        ParsedToml above = parse_toml(layers.above, layers.above_source);
        both.mistakes = std::move(above.mistakes);
        if (above.is_whole) lay_over(below.root, std::move(above.root), layers.above_source, both.mistakes);
    }
    read_into(both, below.root, source, without_font);
    return both;
}

CheckedConfiguration check_configuration_file(const std::filesystem::path& path, std::optional<std::string>* toml) {
    constexpr std::size_t kLargest = 1U << 20U;
    std::string read;
    try {
        read = base::read_file(path, kLargest);
    } catch (const base::InputError& error) {
        return unusable(path.string(),
                        fmt::format("{}; put a file of settings there that everybody may read", error.what()));
    }
    CheckedConfiguration checked = check_configuration(read, path.string());
    if (toml != nullptr) *toml = std::move(read);
    return checked;
}

Configuration configuration_from(std::string_view toml, const std::string& source) {
    return required(check_configuration(toml, source));
}

Configuration read_configuration(const std::filesystem::path& path) { return required(check_configuration_file(path)); }

std::string text(const Configuration& configuration, const std::string& key, std::string_view language) {
    assert(std::ranges::find(genome::kPrompts, key) != genome::kPrompts.end());
    const std::string spoken(language.empty() ? std::string_view(configuration.visit.language) : language);
    if (const auto own = configuration.texts_in.find(spoken); own != configuration.texts_in.end())
        if (const auto found = own->second.find(key); found != own->second.end()) return found->second;
    if (!language.empty() && language != configuration.visit.language)
        return std::string(genome::prompt(language, key));
    if (const auto found = configuration.texts.find(key); found != configuration.texts.end()) return found->second;
    return std::string(genome::prompt(configuration.visit.language, key));
}

}  // namespace quadrat::site
