// SPDX-License-Identifier: Apache-2.0
#include "desk/texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "desk/embedded_texts.hpp"

namespace quadrat::desk {
namespace {

using nlohmann::json;

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

// Of "de;q=0.7", in thousandths; what is not of that form is not wanted.
int weight_of(std::string_view parameters) {
    parameters = trimmed(parameters);
    if (parameters.empty()) return 1000;
    if (!parameters.starts_with("q=")) return 0;
    parameters.remove_prefix(2);
    if (parameters.empty() || parameters.size() > 5 || (parameters[0] != '0' && parameters[0] != '1')) return 0;
    int weight = 1000 * (parameters[0] - '0');
    if (parameters.size() > 1 && parameters[1] != '.') return 0;
    int worth = 100;
    for (std::size_t i = 2; i < parameters.size(); ++i, worth /= 10) {
        if (parameters[i] < '0' || parameters[i] > '9') return 0;
        weight += worth * (parameters[i] - '0');
    }
    return std::min(weight, 1000);
}

}  // namespace

Texts Texts::from_json(std::string_view text, std::string code, std::string_view source) {
    Texts texts;
    texts.code_ = std::move(code);
    try {
        const json read = json::parse(text);
        texts.name_ = read.at("language").get<std::string>();
        texts.direction_ = read.at("direction").get<std::string>();
        for (const auto& [key, value] : read.at("texts").items()) texts.texts_[key] = value.get<std::string>();
    } catch (const json::exception& error) {
        throw base::InputError(fmt::format("{}: {}", source, error.what()));
    }
    if (texts.direction_ != "ltr" && texts.direction_ != "rtl")
        throw base::InputError(fmt::format("{}: direction is \"ltr\" or \"rtl\"", source));
    return texts;
}

const std::string& Texts::operator()(std::string_view key) const {
    if (const auto own = texts_.find(key); own != texts_.end()) return own->second;
    static const std::map<std::string, std::string, std::less<>> kNone;
    const Texts* english = language_of("en");
    const auto& other = english == nullptr ? kNone : english->texts_;
    if (const auto there = other.find(key); there != other.end()) return there->second;
    static const std::string kNothing;
    return kNothing;
}

std::string Texts::operator()(std::string_view key, std::initializer_list<std::string> holes) const {
    std::string text;
    std::string_view rest = (*this)(key);
    for (const std::string& hole : holes) {
        const std::size_t at = rest.find("{}");
        if (at == std::string_view::npos) break;
        text.append(rest.substr(0, at)).append(hole);
        rest.remove_prefix(at + 2);
    }
    return text.append(rest);
}

const std::vector<Texts>& languages() {
    static const std::vector<Texts> kLanguages = [] {
        std::vector<Texts> spoken;
        for (const base::EmbeddedText& text : language_texts())
            spoken.push_back(
                Texts::from_json(text.text, std::string(text.name), fmt::format("desk/languages/{}.json", text.name)));
        std::ranges::sort(spoken, {}, &Texts::code);
        return spoken;
    }();
    return kLanguages;
}

const Texts* language_of(std::string_view code) {
    std::string small;
    for (const char c : code.substr(0, code.find_first_of("-_.@")))
        small += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const auto found = std::ranges::find(languages(), small, &Texts::code);
    return found == languages().end() ? nullptr : &*found;
}

const Texts& preferred_language(std::string_view accepted) {
    const Texts* best = nullptr;
    int most = 0;
    while (!accepted.empty()) {
        const std::size_t end = std::min(accepted.find(','), accepted.size());
        const std::string_view one = accepted.substr(0, end);
        accepted.remove_prefix(std::min(end + 1, accepted.size()));
        const std::size_t semicolon = std::min(one.find(';'), one.size());
        const Texts* spoken = language_of(trimmed(one.substr(0, semicolon)));
        const int weight = weight_of(one.substr(std::min(semicolon + 1, one.size())));
        if (spoken == nullptr || weight <= most) continue;
        best = spoken;
        most = weight;
    }
    return best == nullptr ? *language_of("en") : *best;
}

}  // namespace quadrat::desk
