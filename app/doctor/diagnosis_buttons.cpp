// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "doctor/diagnosis_access.hpp"
#include "site/screen.hpp"

namespace quadrat::doctor {
namespace {

namespace fs = std::filesystem;

Finding input_finding(const std::string& spec, const OpenButtons& open) {
    try {
        const auto [source, map_trouble] = open(spec);
        const auto status = source->look();
        if (!map_trouble.empty())
            return {"buttons", Health::Doubtful, fmt::format("{}: {}", spec, map_trouble),
                    "until then the usual order of buttons is used; teach them: sudo quadrat doctor --learn-buttons"};
        if (status.presence == firmware_io::Presence::Present)
            return {"buttons", Health::Good, fmt::format("{} {}", spec, status.reason), ""};
        return {"buttons", Health::Bad, fmt::format("{}: {}", spec, status.reason),
                "plug it in, or free it; the exhibit keeps looking for it"};
    } catch (const std::invalid_argument& error) {
        return {"buttons", Health::Bad, error.what(), "correct it in the configuration, buttons.inputs"};
    }
}

// What the service cannot read, or does not see at all (ProtectHome=), whoever may read it from a terminal.
bool is_hidden_from(const machine::Account& exhibit, const fs::path& file) {
    const std::string path = fs::absolute(file).lexically_normal().string();
    for (const char* home : {"/root/", "/home/", "/run/user/"})
        if (path.starts_with(home)) return true;
    return !machine::may_read(exhibit, file);
}

std::optional<Finding> map_finding(const std::string& spec, const std::optional<machine::Account>& exhibit) {
    try {
        const auto parsed = firmware_io::parse_input_spec(spec);
        const auto* hid = std::get_if<firmware_io::HidSpec>(&parsed);
        if (hid == nullptr || hid->mappings_file.empty() || !exhibit || !is_hidden_from(*exhibit, hid->mappings_file))
            return std::nullopt;
        return Finding{
            "buttons", Health::Doubtful,
            fmt::format("{}: the user {} cannot read this map of buttons", hid->mappings_file, exhibit->name),
            "move it to /var/lib/quadrat and name it there, buttons.inputs; chmod 644"};
    } catch (const std::invalid_argument&) {
        return std::nullopt;  // as the finding of the input itself says
    }
}

// What else could be named, so that nobody has to guess.
std::optional<Finding> beside_finding(const std::string& spec, const std::vector<std::string>& inputs,
                                      const OpenButtons& open) {
    for (const std::string& input : inputs)
        if (input.starts_with(spec)) return std::nullopt;
    const auto status = open(spec).source->look();
    if (status.presence == firmware_io::Presence::Absent || status.reason.empty()) return std::nullopt;
    return Finding{"buttons", Health::Good, fmt::format("{} would hear {}", spec, status.reason), ""};
}

// What an exhibit hears that names no input: whatever HID controller there is, and the keyboard in a window.
Finding unnamed_finding(const site::Configuration& configuration, const OpenButtons& open) {
    if (configuration.screen.display == "headless")
        return {"buttons", Health::Good, "none are named, and no screen is: a visitor is played", ""};
    const bool is_window = configuration.screen.display == "window";
    Finding finding = input_finding(site::default_inputs("kms").front(), open);
    finding.what = "none are named in the configuration; " + finding.what;
    if (finding.health != Health::Bad) return finding;
    if (is_window)
        return {"buttons", Health::Good, "none are named in the configuration; the window's keyboard is", ""};
    finding.remedy = "nobody can press anything: name yours under buttons.inputs, or plug a controller in";
    return finding;
}

// A keyboard reaches a window alone.
std::optional<Finding> keyboard_finding(const site::Configuration& configuration) {
    const bool is_all = std::ranges::all_of(configuration.inputs, [](const auto& spec) { return spec == "keyboard"; });
    if (!is_all || configuration.screen.display != "kms") return std::nullopt;
    return Finding{"buttons", Health::Bad, "buttons.inputs names the keyboard alone, which only a window hears",
                   "name buttons: hid: or gpio:…; or write display = \"window\""};
}

}  // namespace

std::vector<Finding> examine_buttons(const site::Configuration& configuration,
                                     const std::optional<machine::Account>& exhibit, const OpenButtons& open,
                                     const fs::path& dev) {
    std::vector<Finding> findings;
    for (const std::string& spec : configuration.inputs) {
        findings.push_back(input_finding(spec, open));
        if (auto map = map_finding(spec, exhibit)) findings.push_back(std::move(*map));
    }
    if (configuration.inputs.empty())
        findings.push_back(unnamed_finding(configuration, open));
    else if (auto keyboard = keyboard_finding(configuration))
        findings.push_back(std::move(*keyboard));
    findings.push_back(access_finding({"buttons", "GPIO chips", "gpiochip", "gpio"}, dev, exhibit));
    findings.push_back(access_finding({"buttons", "HID devices", "hidraw", "input"}, dev, exhibit));
    findings.push_back(access_finding({"buttons", "input devices", "event", "input"}, dev / "input", exhibit));
    return findings;
}

std::vector<Finding> examine_boards(const site::Configuration& configuration, const OpenButtons& open) {
    std::vector<Finding> findings;
    for (const char* spec : {"hid:", "evdev:"})
        if (auto beside = beside_finding(spec, configuration.inputs, open)) findings.push_back(std::move(*beside));
    return findings;
}

}  // namespace quadrat::doctor
