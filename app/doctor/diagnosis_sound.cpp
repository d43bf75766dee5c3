// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "doctor/diagnosis.hpp"
#include "doctor/diagnosis_access.hpp"
#include "sound/output.hpp"
#include "sound/speaker.hpp"

namespace quadrat::doctor {
namespace {

Finding card_finding(const std::string& device) {
    const std::string trouble = sound::trouble_with_alsa(device);
    if (trouble.empty()) return {"sound", Health::Good, fmt::format("the card {} can be played on", device), ""};
    return {"sound", Health::Doubtful, trouble,
            "plug it in: the exhibit takes it when it comes; or name another under [sound], as aplay -L lists them"};
}

std::vector<std::string> languages_of(const site::Configuration::Visit& visit) {
    std::vector<std::string> languages{visit.language};
    for (const std::string& one : visit.languages)
        if (std::ranges::find(languages, one) == languages.end()) languages.push_back(one);
    return languages;
}

std::vector<Finding> speech_findings(const site::Configuration& configuration, const std::string& program) {
    std::vector<Finding> findings;
    sound::Speaker speaker(configuration.sound.speech_folder, program);
    for (const std::string& language : languages_of(configuration.visit)) {
        speaker.say({language, "", "A"});
        if (!speaker.trouble().empty())
            findings.push_back({"sound", Health::Doubtful, speaker.trouble(),
                                "questions can be recorded: sound.speech_folder; what the four look like is then not "
                                "spoken in this language"});
    }
    if (findings.empty()) findings.push_back({"sound", Health::Good, "every language of the site has a voice", ""});
    return findings;
}

}  // namespace

std::vector<Finding> examine_sound(const site::Configuration& configuration,
                                   const std::optional<machine::Account>& exhibit, const std::filesystem::path& dev_snd,
                                   const std::string& voice) {
    const site::Configuration::Sound& sound = configuration.sound;
    if (!sound.is_on) return {{"sound", Health::Good, "sound is off, as the settings say", ""}};
    std::vector<Finding> findings;
    const Finding nodes = access_finding({"sound", "sound cards' nodes", "pcm", "audio"}, dev_snd, exhibit);
    if (nodes.health != Health::Good) findings.push_back(nodes);
    findings.push_back(card_finding(sound.device));
    if (!sound.private_device.empty()) findings.push_back(card_finding(sound.private_device));
    if (!sound.speaks) return findings;
    const std::vector<Finding> speech = speech_findings(configuration, voice);
    findings.insert(findings.end(), speech.begin(), speech.end());
    return findings;
}

}  // namespace quadrat::doctor
