// SPDX-License-Identifier: Apache-2.0
#include "kiosk/staff/vitals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace quadrat::kiosk::staff {
namespace {

using firmware_io::Ailment;
using firmware_io::Presence;

const char* name_of(Verdict verdict) {
    constexpr const char* kNames[] = {"good", "doubtful", "bad"};
    return kNames[static_cast<std::size_t>(verdict)];
}

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

}  // namespace

void FrameCount::frame(std::chrono::nanoseconds now, std::chrono::nanoseconds period, int periods) {
    ++frames;
    if (last_) {
        const auto took = now - *last_;
        longest_ms = std::max(longest_ms, std::chrono::duration<double, std::milli>(took).count());
        if (period.count() > 0 && took > period * periods + period / 2) ++late;
    }
    last_ = now;
    ++in_second_;
    const auto since = now - second_began_;
    if (since >= std::chrono::seconds{1}) {
        per_second = in_second_ / std::chrono::duration<double>(since).count();
        second_began_ = now;
        in_second_ = 0;
    }
}

void FrameCount::begin_anew() {
    last_.reset();
    second_began_ = std::chrono::nanoseconds{0};
    in_second_ = 0;
}

Verdict verdict_of(const Vitals& vitals) {
    if (vitals.buttons.presence == Presence::Absent || !vitals.screen_trouble.empty()) return Verdict::Bad;
    const bool is_doubtful = vitals.mode == Mode::Safe || !vitals.state_trouble.empty() ||
                             vitals.machine.is_throttled.value_or(false) || vitals.free_mb.value_or(1000) < 20 ||
                             std::any_of(vitals.findings.begin(), vitals.findings.end(), is_serious);
    return is_doubtful ? Verdict::Doubtful : Verdict::Good;
}

std::string to_json(const Vitals& vitals) {
    nlohmann::json json;
    json["verdict"] = name_of(verdict_of(vitals));
    json["version"] = vitals.version;
    json["name"] = vitals.machine.name;
    json["mode"] = vitals.mode == Mode::Safe ? "safe" : "usual";
    json["failures_10min"] = vitals.failures;
    json["running_s"] = vitals.running.count();
    json["display"] = vitals.display;
    json["screen_trouble"] = vitals.screen_trouble;
    json["frames"] = {{"shown", vitals.frames.frames},
                      {"late", vitals.frames.late},
                      {"longest_ms", vitals.frames.longest_ms},
                      {"per_second", vitals.frames.per_second}};
    json["level"] = vitals.level;
    json["alpha"] = vitals.alpha;
    json["gpu_objects"] = vitals.gpu_objects;
    json["buttons"] = {{"present", vitals.buttons.presence == Presence::Present},
                       {"reason", vitals.buttons.reason},
                       {"presses", vitals.presses}};
    auto& findings = json["buttons"]["findings"] = nlohmann::json::array();
    for (const auto& finding : vitals.findings)
        findings.push_back({{"button", name_of(finding.button)}, {"is", name_of(finding.ailment)}});
    for (const Ailment ailment : firmware_io::kAilments)
        for (const auto button : firmware_io::kButtons)
            json["buttons"]["counts"][std::string(name_of(ailment))][std::string(name_of(button))] =
                vitals.ailments[static_cast<std::size_t>(ailment)][index_of(button)];
    json["visits"] = vitals.visits;
    json["state_trouble"] = vitals.state_trouble;
    if (vitals.free_mb) json["free_mb"] = *vitals.free_mb;
    if (vitals.machine.temperature_c) json["temperature_c"] = *vitals.machine.temperature_c;
    if (vitals.machine.is_throttled) json["throttled"] = *vitals.machine.is_throttled;
    json["memory_mb"] = vitals.machine.memory_mb;
    json["written_bytes"] = vitals.machine.written_bytes;
    json["descriptors"] = vitals.machine.descriptors;
    json["faults"] = vitals.faults;
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
    text += metric("screen_up", "gauge", "1 while the screen shows", vitals.screen_trouble.empty() ? 1 : 0);
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
    if (vitals.free_mb) text += metric("free_megabytes", "gauge", "Left on the state's disk", *vitals.free_mb);
    if (vitals.machine.temperature_c)
        text += metric("temperature_celsius", "gauge", "The warmest sensor", *vitals.machine.temperature_c);
    if (vitals.machine.is_throttled)
        text += metric("throttled", "gauge", "1 while heat or low voltage slow the machine",
                       *vitals.machine.is_throttled ? 1 : 0);
    text += metric("memory_megabytes", "gauge", "Resident", vitals.machine.memory_mb);
    text += metric("written_bytes_total", "counter", "Written to disk by the program", vitals.machine.written_bytes);
    return text;
}

}  // namespace quadrat::kiosk::staff
