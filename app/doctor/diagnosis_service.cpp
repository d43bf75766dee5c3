// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "doctor/diagnosis.hpp"
#include "site/settings.hpp"
#include "staff/watch.hpp"

namespace quadrat::doctor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::chrono::minutes kStale{3};  // health is written once a minute
constexpr std::size_t kLargestHealth = 1U << 20U;

Finding stale(const fs::path& file) {
    return {"service", Health::Bad,
            fmt::format("{} is more than {} minutes old: the exhibit has stopped", file.string(), kStale.count()),
            "see why: journalctl -u quadrat -n 50; start it: systemctl restart quadrat"};
}

std::string text_in(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

// Which settings it has instead of its file's.
std::vector<std::string> settings_trouble_in(const json& health) {
    const json settings = health.value("settings", json::object());
    const json mistakes = settings.is_object() ? settings.value("mistakes", json::array()) : json::array();
    if (!mistakes.is_array() || mistakes.empty()) return {};
    const std::string from = text_in(settings, "from");
    const site::SettingsFrom used = from == "defaults"    ? site::SettingsFrom::Defaults
                                    : from == "last good" ? site::SettingsFrom::LastGood
                                                          : site::SettingsFrom::File;
    return {fmt::format("its settings file cannot be used ({} mistake{}): {}", mistakes.size(),
                        mistakes.size() == 1 ? "" : "s", site::in_words(used))};
}

std::vector<Finding> findings_in(const json& health) {
    std::vector<Finding> findings;
    const auto add = [&](Health how, std::string what, std::string remedy) {
        findings.push_back({"service", how, std::move(what), std::move(remedy)});
    };
    const auto wished = health.find("safe_as_wished");
    if (wished != health.end() && *wished == true)
        add(Health::Doubtful, "it runs in safe mode, as staff wish",
            "leave it: \"Usual mode\" on the staff's page, or rm /run/quadrat/safe-mode and systemctl restart quadrat");
    else if (text_in(health, "mode") == "safe")
        add(Health::Doubtful, "it runs in safe mode: it failed three times within ten minutes",
            "see why: journalctl -u quadrat -p err -n 50; leave safe mode: systemctl restart quadrat, after ten "
            "minutes");
    if (const std::string trouble = text_in(health, "screen_trouble"); !trouble.empty())
        add(Health::Bad, "its screen: " + trouble,
            "check the projector and its cable; the exhibit takes it when it comes");
    if (const std::string trouble = text_in(health, "state_trouble"); !trouble.empty())
        add(Health::Doubtful, "it keeps nothing: " + trouble,
            "make room, or give it a working disk: df -h; dmesg | tail");
    const json sound = health.value("sound", json::object());
    if (const std::string trouble = sound.is_object() ? text_in(sound, "trouble") : ""; !trouble.empty())
        add(Health::Doubtful, "its sound: " + trouble, "see what mends it: quadrat doctor --only sound");
    for (std::string& line : settings_trouble_in(health))
        add(Health::Doubtful, std::move(line), "correct it: quadrat doctor --only settings; it is then taken over");
    const json buttons = health.value("buttons", json::object());
    if (buttons.is_object() && !buttons.value("present", true))
        add(Health::Bad, "its buttons: " + text_in(buttons, "reason"),
            "plug them in; the exhibit takes them when they come");
    for (const json& one : buttons.is_object() ? buttons.value("findings", json::array()) : json::array())
        if (one.is_object())
            add(Health::Doubtful, fmt::format("button {} is {}", text_in(one, "button"), text_in(one, "is")),
                "look at the button and its cable; the visit goes on without it");
    if (health.value("throttled", false))
        add(Health::Doubtful, "the machine is slowed down by heat or low voltage",
            "clear its air holes; use the power supply that belongs to it");
    return findings;
}

}  // namespace

std::vector<Finding> examine_unit(const std::optional<machine::UnitState>& unit) {
    if (!unit || unit->load == "not-found") return {};
    const auto found = [](Health how, const std::string& what, std::string remedy) {
        return std::vector{Finding{"service", how, fmt::format("quadrat.service {}", what), std::move(remedy)}};
    };
    if (unit->load == "masked")
        return found(Health::Bad, "is masked: nothing starts it",
                     "systemctl unmask quadrat; systemctl enable --now quadrat");
    if (unit->active == "failed")
        return found(Health::Bad, fmt::format("has failed ({})", unit->result),
                     "see why: journalctl -u quadrat -n 50; start it: systemctl restart quadrat");
    if (unit->file != "enabled")
        return found(Health::Doubtful, "does not start with the machine", "systemctl enable --now quadrat");
    if (unit->active == "inactive") return found(Health::Bad, "is stopped", "start it: systemctl start quadrat");
    if (unit->active != "active")
        return found(Health::Doubtful, fmt::format("is {}; its last end was: {}", unit->active, unit->result),
                     "if it stays so: journalctl -u quadrat -n 50");
    return found(Health::Good, "is enabled and runs", "");
}

std::vector<Finding> examine_service(const fs::path& runtime) {
    const fs::path file = runtime / "health.json";
    std::error_code error;
    if (!fs::exists(file, error)) return {{"service", Health::Good, "no exhibit runs here as a service", ""}};
    const auto age = fs::file_time_type::clock::now() - fs::last_write_time(file, error);
    if (error || age > kStale) return {stale(file)};
    const json health = [&] {
        try {
            return json::parse(base::read_file(file, kLargestHealth), nullptr, false);
        } catch (const base::InputError&) {
            return json(json::value_t::discarded);
        }
    }();
    if (!health.is_object())
        return {{"service", Health::Doubtful, fmt::format("{} cannot be read", file.string()), "run this as root"}};
    std::vector<Finding> findings = findings_in(health);
    if (findings.empty()) findings.push_back({"service", Health::Good, "the exhibit runs and finds nothing wrong", ""});
    // Whoever asks why nothing is on the screen has the answer.
    if (text_in(health, "screen") == "dark")
        findings.push_back({"service", Health::Good,
                            fmt::format("its screen is dark as planned: {}", text_in(health, "opening")), ""});
    return findings;
}

}  // namespace quadrat::doctor
