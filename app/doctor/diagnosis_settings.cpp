// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "doctor/diagnosis.hpp"
#include "site/configuration_checks.hpp"
#include "site/settings.hpp"

namespace quadrat::doctor {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSubject = "settings";

// What the service does about it, in the words that a remedy ends with.
std::string meanwhile(const fs::path& state) {
    std::error_code error;
    if (state.empty()) return "";
    return fs::exists(site::last_good_file(state), error)
               ? ". Until then the service uses the last settings that worked: " + site::last_good_file(state).string()
               : ". Until then the service uses the defaults: it keeps no settings that worked";
}

std::optional<Finding> fonts_finding(const site::Configuration& configuration) {
    const std::string missing = site::letters_missing_for(configuration, render::letters_without_font);
    if (missing.empty()) return std::nullopt;
    return Finding{kSubject, Health::Bad,
                   fmt::format("the screen's words cannot be shown: no installed font has the letters {}", missing),
                   "install fonts: apt install fonts-lato fonts-noto-core fonts-droid-fallback"};
}

const char* word_for(Health health) {
    constexpr const char* kWords[] = {"good", "doubtful", "bad"};
    return kWords[static_cast<std::size_t>(health)];
}

}  // namespace

Examined examine_configuration(const fs::path& file, const fs::path& state) {
    std::error_code error;
    if (file.empty() && !fs::exists(site::curated_file(state), error)) {
        Examined none{{}, {{kSubject, Health::Good, "no file is named, so the defaults are used", ""}}};
        if (auto fonts = fonts_finding(none.configuration)) none.findings.push_back(std::move(*fonts));
        return none;
    }
    site::CheckedConfiguration checked = site::check_settings(file, state);
    if (auto cut = site::cut_off_from_last_good(file, state); cut && checked.is_usable())
        checked.mistakes.push_back(std::move(*cut));
    Examined examined{std::move(checked.configuration), {}};
    for (const site::Mistake& mistake : checked.mistakes) {
        site::Mistake plain = mistake;
        plain.remedy.clear();
        const std::string remedy = mistake.remedy.empty() ? "correct it" : mistake.remedy;
        const bool is_last = &mistake == &checked.mistakes.back();
        examined.findings.push_back({kSubject, Health::Bad, to_text(plain), remedy + (is_last ? meanwhile(state) : ""),
                                     mistake.file, mistake.line});
    }
    if (checked.mistakes.empty()) {
        const std::string also =
            fs::exists(site::curated_file(state), error)
                ? fmt::format(", and over it what was said at the desk, {}", site::curated_file(state).string())
                : "";
        const std::string named = file.empty() ? "no file is named, which" : file.string();
        examined.findings.push_back({kSubject, Health::Good, named + " can be used" + also, "", file.string()});
        if (auto fonts = fonts_finding(examined.configuration)) examined.findings.push_back(std::move(*fonts));
    }
    return examined;
}

std::string json_of(const std::vector<Finding>& findings) {
    nlohmann::ordered_json json{{"verdict", word_for(worst_of(findings))},
                                {"findings", nlohmann::ordered_json::array()}};
    for (const Finding& finding : findings)
        json["findings"].push_back({{"part", finding.subject},
                                    {"verdict", word_for(finding.health)},
                                    {"what", finding.what},
                                    {"remedy", finding.remedy},
                                    {"file", finding.file},
                                    {"line", finding.line}});
    return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace quadrat::doctor
