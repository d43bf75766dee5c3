// SPDX-License-Identifier: Apache-2.0
#include "staff/vitals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "site/wall_clock.hpp"

namespace quadrat::staff {
namespace {

using firmware_io::Ailment;
using firmware_io::Presence;

const char* name_of(Verdict verdict) {
    constexpr const char* kNames[] = {"good", "doubtful", "bad"};
    return kNames[static_cast<std::size_t>(verdict)];
}

constexpr const char* kScreenStates[] = {"shows", "card", "dark", "failed"};

bool is_serious(const firmware_io::Finding& finding) {
    return finding.ailment == Ailment::Stuck || finding.ailment == Ailment::Chattering ||
           finding.ailment == Ailment::Dead;
}

std::string one_metric(const char* name, const char* kind, const char* help, const std::string& samples) {
    return fmt::format("# HELP quadrat_{0} {1}\n# TYPE quadrat_{0} {2}\n{3}", name, help, kind, samples);
}

template <typename Number>
std::string metric(const char* name, const char* kind, const char* help, Number value) {
    return one_metric(name, kind, help, fmt::format("quadrat_{} {}\n", name, value));
}

std::string screen_metrics(const Vitals& vitals) {
    const ScreenState state = screen_state(vitals);
    std::string states;
    for (const ScreenState one : {ScreenState::Shows, ScreenState::Card, ScreenState::Dark, ScreenState::Failed})
        states += fmt::format("quadrat_screen_state{{state=\"{}\"}} {}\n", kScreenStates[static_cast<std::size_t>(one)],
                              one == state ? 1 : 0);
    const bool is_lit = state == ScreenState::Shows || state == ScreenState::Card;
    return metric("screen_up", "gauge", "1 while the screen shows something", is_lit ? 1 : 0) +
           metric("screen_failed", "gauge", "1 while the screen should show something and does not",
                  state == ScreenState::Failed ? 1 : 0) +
           one_metric("screen_state", "gauge",
                      "1 for what it does: shows, card (closed), dark (closed, as planned), failed", states);
}

std::string clock_metrics(const Vitals& vitals) {
    const std::string source = vitals.wall.source.empty() ? "none" : vitals.wall.source;
    return metric("open", "gauge", "1 while the opening hours say so", vitals.is_open ? 1 : 0) +
           metric("clock_trusted", "gauge", "1 while the clock can be trusted", vitals.wall.is_trusted ? 1 : 0) +
           one_metric("clock_source", "gauge", "1 for why the clock is trusted: synchronised, a real-time clock, none",
                      fmt::format("quadrat_clock_source{{source=\"{}\"}} 1\n", source));
}

nlohmann::json settings_json(const SettingsNews& news) {
    constexpr const char* kFrom[] = {"file", "last good", "defaults"};
    nlohmann::json json;
    json["from"] = kFrom[static_cast<std::size_t>(news.from)];
    json["after_restart"] = news.after_restart;
    auto& mistakes = json["mistakes"] = nlohmann::json::array();
    for (const site::Mistake& mistake : news.mistakes)
        mistakes.push_back(
            {{"file", mistake.file}, {"line", mistake.line}, {"what", mistake.what}, {"remedy", mistake.remedy}});
    return json;
}

std::string settings_metrics(const SettingsNews& news) {
    return metric("settings_up", "gauge", "1 while the settings file is followed", news.mistakes.empty() ? 1 : 0) +
           metric("settings_mistakes", "gauge", "Mistakes in the settings file", news.mistakes.size()) +
           metric("settings_from", "gauge", "Settings in use: 0 the file's, 1 the last that worked, 2 the defaults",
                  static_cast<int>(news.from));
}

nlohmann::json sound_of(const hearing::Health& sound) {
    return {{"wanted", sound.is_wanted},
            {"plays", sound.is_playing},
            {"trouble", sound.trouble},
            {"underruns", sound.underruns},
            {"dropped", sound.dropped}};
}

nlohmann::json projector_of(const projector::Told& told) {
    return {{"power", told.power ? name_of(*told.power) : ""}, {"trouble", told.trouble}, {"remedy", told.remedy}};
}

nlohmann::json buttons_of(const Vitals& vitals) {
    nlohmann::json json = {{"present", vitals.buttons.presence == Presence::Present},
                           {"reason", vitals.buttons.reason},
                           {"presses", vitals.presses}};
    json["tests_lamps"] = vitals.tests_lamps;
    auto& each = json["each"] = nlohmann::json::array();
    for (const auto button : firmware_io::kButtons)
        each.push_back({{"button", name_of(button)},
                        {"closed", vitals.is_closed[index_of(button)]},
                        {"presses", vitals.presses_of[index_of(button)]}});
    auto& findings = json["findings"] = nlohmann::json::array();
    for (const auto& finding : vitals.findings)
        findings.push_back({{"button", name_of(finding.button)}, {"is", name_of(finding.ailment)}});
    for (const Ailment ailment : firmware_io::kAilments)
        for (const auto button : firmware_io::kButtons)
            json["counts"][std::string(name_of(ailment))][std::string(name_of(button))] =
                vitals.ailments[static_cast<std::size_t>(ailment)][index_of(button)];
    return json;
}

}  // namespace

void FrameCount::frame(const tempo::FrameRecord& record) {
    ++frames;
    longest_ms = std::max(longest_ms, std::chrono::duration<double, std::milli>(tempo::took(record)).count());
    late += tempo::is_late(record);
    ++in_second_;
    const auto since = record.shown - second_began_;
    if (since < std::chrono::seconds{1}) return;
    per_second = in_second_ / std::chrono::duration<double>(since).count();
    second_began_ = record.shown;
    in_second_ = 0;
}

ScreenState screen_state(const Vitals& vitals) {
    if (!vitals.screen_trouble.empty()) return ScreenState::Failed;
    if (vitals.curtain == site::Curtain::Card) return ScreenState::Card;
    return vitals.curtain == site::Curtain::Dark ? ScreenState::Dark : ScreenState::Shows;
}

Verdict verdict_of(const Vitals& vitals) {
    if (vitals.buttons.presence == Presence::Absent || !vitals.screen_trouble.empty()) return Verdict::Bad;
    const bool is_doubtful =
        vitals.mode == Mode::Safe || !vitals.state_trouble.empty() || !vitals.settings.mistakes.empty() ||
        vitals.machine.is_throttled.value_or(false) || vitals.free_mb.value_or(1000) < 20 ||
        !vitals.sound.trouble.empty() || !vitals.postcard_trouble.empty() ||
        (vitals.projector && !vitals.projector->trouble.empty()) || (vitals.has_hours && !vitals.wall.is_trusted) ||
        std::any_of(vitals.findings.begin(), vitals.findings.end(), is_serious);
    return is_doubtful ? Verdict::Doubtful : Verdict::Good;
}

std::string to_json(const Vitals& vitals) {
    nlohmann::json json;
    json["verdict"] = name_of(verdict_of(vitals));
    json["version"] = vitals.version;
    json["name"] = vitals.machine.name;
    json["mode"] = vitals.mode == Mode::Safe ? "safe" : "usual";
    json["safe_as_wished"] = vitals.is_safe_as_wished;
    json["failures_10min"] = vitals.failures;
    json["running_s"] = vitals.running.count();
    json["display"] = vitals.display;
    json["screen"] = kScreenStates[static_cast<std::size_t>(screen_state(vitals))];
    json["screen_trouble"] = vitals.screen_trouble;
    json["open"] = vitals.is_open;
    json["opening"] = vitals.opening;
    json["standing_by"] = vitals.stands_by;
    json["clock"] = {{"time", site::time_text(vitals.wall)},
                     {"zone", vitals.wall.zone},
                     {"trusted", vitals.wall.is_trusted},
                     {"source", vitals.wall.source},
                     {"doubt", vitals.wall.doubt}};
    json["frames"] = {{"shown", vitals.frames.frames},
                      {"late", vitals.frames.late},
                      {"longest_ms", vitals.frames.longest_ms},
                      {"per_second", vitals.frames.per_second}};
    json["level"] = vitals.level;
    json["alpha"] = vitals.alpha;
    json["gpu_objects"] = vitals.gpu_objects;
    json["buttons"] = buttons_of(vitals);
    json["visits"] = vitals.visits;
    json["state_trouble"] = vitals.state_trouble;
    json["sound"] = sound_of(vitals.sound);
    json["postcards"] = {{"trouble", vitals.postcard_trouble}};
    if (vitals.projector) json["projector"] = projector_of(*vitals.projector);
    if (vitals.free_mb) json["free_mb"] = *vitals.free_mb;
    if (vitals.machine.temperature_c) json["temperature_c"] = *vitals.machine.temperature_c;
    if (vitals.machine.is_throttled) json["throttled"] = *vitals.machine.is_throttled;
    json["memory_mb"] = vitals.machine.memory_mb;
    json["written_bytes"] = vitals.machine.written_bytes;
    json["descriptors"] = vitals.machine.descriptors;
    json["faults"] = vitals.faults;
    json["settings"] = settings_json(vitals.settings);
    json["theme"] = vitals.theme;
    json["earlier_faults"] = vitals.earlier_faults;
    // A device may call itself anything: bytes that are no UTF-8 are replaced.
    return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string to_prometheus(const Vitals& vitals) {
    std::string text;
    text += metric("verdict", "gauge", "0 good, 1 doubtful, 2 bad", static_cast<int>(verdict_of(vitals)));
    text += metric("safe_mode", "gauge", "1 while the exhibit runs in safe mode", vitals.mode == Mode::Safe ? 1 : 0);
    text += metric("failures", "gauge", "Failures of the last ten minutes", vitals.failures);
    text += metric("running_seconds", "gauge", "Since the program started", vitals.running.count());
    text += screen_metrics(vitals) + clock_metrics(vitals);
    text += metric("frames_total", "counter", "Frames handed over", vitals.frames.frames);
    text += metric("frames_late_total", "counter", "Frames that missed their moment", vitals.frames.late);
    text += metric("gpu_objects", "gauge", "Buffers, textures and programs on the GPU", vitals.gpu_objects);
    text += metric("buttons_up", "gauge", "1 while buttons are there",
                   vitals.buttons.presence == Presence::Present ? 1 : 0);
    text += metric("presses_total", "counter", "Presses heard", vitals.presses);
    std::string ailments;
    for (const Ailment ailment : firmware_io::kAilments)
        for (const auto button : firmware_io::kButtons)
            ailments +=
                fmt::format("quadrat_button_ailments_total{{button=\"{}\",ailment=\"{}\"}} {}\n", name_of(button),
                            name_of(ailment), vitals.ailments[static_cast<std::size_t>(ailment)][index_of(button)]);
    text += one_metric("button_ailments_total", "counter", "How often each ailment of each button began", ailments);
    text += metric("visits_total", "counter", "Visits that ended", vitals.visits);
    text += metric("state_up", "gauge", "1 while visits are kept", vitals.state_trouble.empty() ? 1 : 0);
    if (vitals.projector)
        text += metric("projector_up", "gauge", "1 while the projector is as it should be",
                       vitals.projector->trouble.empty() ? 1 : 0);
    if (vitals.sound.is_wanted) {
        text += metric("sound_up", "gauge", "1 while sound is played", vitals.sound.is_playing ? 1 : 0);
        text += metric("sound_underruns_total", "counter", "Gaps in the sound", vitals.sound.underruns);
    }
    if (vitals.free_mb) text += metric("free_megabytes", "gauge", "Left on the state's disk", *vitals.free_mb);
    if (vitals.machine.temperature_c)
        text += metric("temperature_celsius", "gauge", "The warmest sensor", *vitals.machine.temperature_c);
    if (vitals.machine.is_throttled)
        text += metric("throttled", "gauge", "1 while heat or low voltage slow the machine",
                       *vitals.machine.is_throttled ? 1 : 0);
    text += metric("memory_megabytes", "gauge", "Resident", vitals.machine.memory_mb);
    text += settings_metrics(vitals.settings);
    text += metric("written_bytes_total", "counter", "Written to disk by the program", vitals.machine.written_bytes);
    return text;
}

}  // namespace quadrat::staff
