// SPDX-License-Identifier: Apache-2.0
#include "genome/speech.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "base/error.hpp"
#include "base/text_file.hpp"
#include "genome/json_text.hpp"
#include "genome/language_po.hpp"
#include "genome/language_texts.hpp"
#include "genome/parameter_ids.hpp"

namespace quadrat::genome {
namespace {

using nlohmann::json;

// Below this nobody would use the word; from kVery on they would add to it.
constexpr float kNoticed = 0.25F;
constexpr float kHeard = 0.08F;  // of two that are described alike, what is worth a word
constexpr float kVery = 0.8F;
constexpr float kNoticedShare = 0.05F;  // of a parameter's range

// The one text between two pieces of a template. `holes` are all it may name.
std::string text_from(const json& object, std::string_view key, std::string_view source,
                      std::initializer_list<std::string_view> holes) {
    const json& value = member(object, key, source);
    if (!value.is_string()) throw base::InputError(fmt::format("{}: {} should be a text", source, key));
    auto text = value.get<std::string>();
    for (const std::string_view hole : holes)
        if (text.find(hole) == std::string::npos)
            throw base::InputError(fmt::format("{}: {} has no place for {}", source, key, hole));
    return text;
}

std::string filled(std::string text, std::string_view hole, std::string_view with) {
    const std::size_t at = text.find(hole);
    if (at != std::string::npos) text.replace(at, hole.size(), with);
    return text;
}

struct Detail {
    ParameterId id;
    std::string_view less;
    std::string_view more;
};
constexpr std::array kDetails{
#define DETAIL(id, less, more) Detail{ParameterId::id, less, more},
#include "genome/details.inc"
#undef DETAIL
};

using Ends = std::array<std::string, 2>;

Ends ends_from(const json& texts, std::string_view key, std::string_view name, const Ends& otherwise,
               std::string_view source) {
    const auto found = texts.find(std::string(name));
    if (found == texts.end()) return otherwise;
    if (!found->is_array() || found->size() != 2 || !(*found)[0].is_string() || !(*found)[1].is_string())
        throw base::InputError(fmt::format("{}: {}.{} should be two texts, low end and high end", source, key, name));
    return {(*found)[0].get<std::string>(), (*found)[1].get<std::string>()};
}

std::map<ParameterId, Ends> details_from(const json& root, std::string_view source) {
    const json texts = root.contains("details") ? root["details"] : json::object();
    if (!texts.is_object()) throw base::InputError(fmt::format("{}: details should be an object", source));
    for (const auto& [name, ends] : texts.items()) {
        const auto id = parameter_named(name);
        if (!id || std::ranges::find(kDetails, *id, &Detail::id) == kDetails.end())
            throw base::InputError(fmt::format("{}: there is no detail \"{}\"", source, name));
    }
    std::map<ParameterId, Ends> details;
    for (const Detail& detail : kDetails)
        details[detail.id] = ends_from(texts, "details", parameter(detail.id).name,
                                       {std::string(detail.less), std::string(detail.more)}, source);
    return details;
}

std::map<std::string, std::string, std::less<>> prompts_from(const json& root, std::string_view source) {
    std::map<std::string, std::string, std::less<>> prompts;
    if (!root.contains("prompts")) return prompts;
    const json& texts = root["prompts"];
    if (!texts.is_object()) throw base::InputError(fmt::format("{}: prompts should be an object of texts", source));
    for (const auto& [key, text] : texts.items()) {
        if (std::ranges::find(kPrompts, key) == kPrompts.end())
            throw base::InputError(fmt::format("{}: there is no prompt {}", source, brief(json(key))));
        prompts[key] = text_from(texts, key, source, {});
    }
    return prompts;
}

// The aspect's words whose measure is large enough to notice, largest first, two at most.
template <typename Measure>
std::vector<WordId> strongest(Aspect aspect, const Measure& measure) {
    std::vector<WordId> ids;
    for (const Word& word : vocabulary(aspect))
        if (std::abs(measure(word.id)) >= kNoticed) ids.push_back(word.id);
    std::ranges::stable_sort(ids, std::greater{}, [&](WordId id) { return std::abs(measure(id)); });
    if (ids.size() > 2) ids.resize(2);
    return ids;
}

}  // namespace

Language Language::from_json(std::string_view text, std::string_view source) {
    const json root = parse_json(text, source);
    require_object(
        root, {"language", "sentence", "and", "very", "rather", "trees", "land", "sky", "words", "details", "prompts"},
        source, "the language");
    Language read;
    read.name_ = text_from(root, "language", source, {});
    read.sentence_ = text_from(root, "sentence", source, {"{trees}", "{land}", "{sky}"});
    read.and_ = text_from(root, "and", source, {"{}"});
    read.very_ = text_from(root, "very", source, {"{}"});
    read.rather_ = text_from(root, "rather", source, {"{}"});
    for (const Aspect aspect : kAspects) {
        const json& phrase = member(root, name_of(aspect), source);
        require_object(phrase, {"with", "plain"}, source, name_of(aspect));
        read.phrases_[aspect] = {text_from(phrase, "with", source, {"{}"}), text_from(phrase, "plain", source, {})};
    }
    const json& words = member(root, "words", source);
    if (!words.is_object()) throw base::InputError(fmt::format("{}: words should be an object", source));
    for (const auto& [name, ends] : words.items())
        if (!word_named(name)) throw base::InputError(fmt::format("{}: there is no word \"{}\"", source, name));
    for (const Word& word : vocabulary())
        read.ends_[static_cast<std::size_t>(word.id)] =
            ends_from(words, "words", word.name, {std::string(word.low), std::string(word.high)}, source);
    read.details_ = details_from(root, source);
    read.prompts_ = prompts_from(root, source);
    return read;
}

std::string Language::adjective(WordId id, float value) const {
    std::string plain(end(id, value > 0));
    return std::abs(value) >= kVery ? filled(very_, "{}", plain) : plain;
}

std::string Language::describe(const Description& description, Aspect aspect) const {
    const auto ids = strongest(aspect, [&](WordId id) { return description[id]; });
    if (ids.empty()) return phrases_[aspect].plain;
    std::string adjectives = adjective(ids[0], description[ids[0]]);
    if (ids.size() == 2)
        adjectives = filled(filled(and_, "{}", adjectives), "{}", adjective(ids[1], description[ids[1]]));
    return filled(phrases_[aspect].with, "{}", adjectives);
}

std::string Language::describe(const Description& description) const {
    std::string text = sentence_;
    for (const Aspect aspect : kAspects)
        text = filled(std::move(text), fmt::format("{{{}}}", name_of(aspect)), describe(description, aspect));
    return text;
}

std::string Language::describe_among(std::span<const std::optional<Description>> all, std::size_t which,
                                     Aspect aspect) const {
    const Description& own = *all[which];
    std::string said = describe(own, aspect);
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i != which && all[i] && describe(*all[i], aspect) == said) alike.push_back(i);
    if (alike.empty()) return said;
    std::optional<WordId> most;
    float farthest = 0;
    for (const Word& word : vocabulary(aspect)) {
        float apart = own[word.id];
        for (const std::size_t other : alike) apart -= (*all[other])[word.id] / static_cast<float>(alike.size());
        if (std::abs(apart) < std::max(kHeard, std::abs(farthest))) continue;
        farthest = apart;
        most = word.id;
    }
    return most ? fmt::format("{}, {}", said, filled(rather_, "{}", std::string(end(*most, farthest > 0)))) : said;
}

std::string Language::heredity(const Description& from, const Description& to, Aspect aspect) const {
    std::string text;
    for (const WordId id : strongest(aspect, [&](WordId word) { return to[word] - from[word]; }))
        text += fmt::format("{}{}", text.empty() ? "" : ", ", end(id, to[id] > from[id]));
    return text;
}

std::string Language::detail(const ParameterShares& moved, Aspect aspect) const {
    const auto far = [&](const Detail& detail) { return std::abs(moved[static_cast<std::size_t>(detail.id)]); };
    const Detail* most = nullptr;
    for (const Detail& detail : kDetails)
        if (parameter(detail.id).aspect == aspect && (most == nullptr || far(detail) > far(*most))) most = &detail;
    if (most == nullptr || far(*most) < kNoticedShare) return {};
    return std::string(detail(most->id, moved[static_cast<std::size_t>(most->id)] > 0));
}

std::string_view Language::detail(ParameterId id, bool is_more) const {
    const auto found = details_.find(id);
    return found == details_.end() ? std::string_view{} : std::string_view{found->second[is_more ? 1 : 0]};
}

std::array<std::string, 4> Language::answers(WordId id) const {
    const auto said = [&](bool is_high, bool is_rather) {
        std::string plain(end(id, is_high));
        return filled(phrases_[word(id).aspect].with, "{}", is_rather ? filled(rather_, "{}", plain) : plain);
    };
    return {said(false, false), said(false, true), said(true, true), said(true, false)};
}

std::string_view Language::prompt(std::string_view key) const {
    const auto found = prompts_.find(key);
    return found == prompts_.end() ? std::string_view{} : std::string_view{found->second};
}

bool Language::reads_right_to_left() const {
    // The Hebrew, Arabic, Syriac, Thaana and N'Ko blocks begin with these bytes in UTF-8.
    const auto first = name_.empty() ? 0U : static_cast<unsigned char>(name_.front());
    return first >= 0xD6 && first <= 0xDF;
}

namespace {

struct File {
    std::string json;
    Language language;
};
using Files = std::map<std::string, File, std::less<>>;

const Files& files_that_come_along() {
    static const Files kFiles = [] {
        Files files;
        for (const base::EmbeddedText& text : language_texts())
            files.emplace(text.name, File{std::string(text.text),
                                          Language::from_json(text.text, fmt::format("languages/{}.json", text.name))});
        return files;
    }();
    return kFiles;
}

// Only ever added to: what was found in it stays where it is.
struct Given {
    std::mutex lock;
    Files files;
};
Given& given() {
    static Given given;
    return given;
}

const File* file_of(std::string_view code) {
    const std::string_view plain = code.substr(0, code.find_first_of("-_.@"));
    {
        Given& from_outside = given();
        const std::scoped_lock hold(from_outside.lock);
        if (const auto found = from_outside.files.find(plain); found != from_outside.files.end()) return &found->second;
    }
    const Files& files = files_that_come_along();
    const auto found = files.find(plain);
    return found == files.end() ? nullptr : &found->second;
}

}  // namespace

void speak_from(const std::string& code, std::string json, std::string_view source) {
    const bool is_code = code.size() >= 2 && code.size() <= 8 &&
                         std::ranges::all_of(code, [](unsigned char c) { return c >= 'a' && c <= 'z'; });
    if (!is_code) throw base::InputError(fmt::format("{}: a language's file is named by its code: de.json", source));
    Language read = Language::from_json(json, source);
    Given& from_outside = given();
    const std::scoped_lock hold(from_outside.lock);
    from_outside.files.try_emplace(code, File{std::move(json), std::move(read)});
}

void speak_from_folder(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) files.push_back(entry.path());
    if (error) throw base::InputError(fmt::format("{}: {}", folder.string(), error.message()));
    std::ranges::sort(files);
    for (const std::filesystem::path& file : files) {
        const bool is_po = file.extension() == ".po";
        if (!is_po && file.extension() != ".json") continue;
        std::string text = base::read_text(file, base::kJsonLimits);
        speak_from(file.stem().string(), is_po ? json_of_po(text, file.string()) : std::move(text), file.string());
    }
}

std::string_view language_json(std::string_view code) {
    const File* file = file_of(code);
    return file == nullptr ? std::string_view{} : std::string_view(file->json);
}

const Language& language(std::string_view code) {
    const File* file = file_of(code);
    return file != nullptr ? file->language : files_that_come_along().at("en").language;
}

std::string_view prompt(std::string_view code, std::string_view key) {
    const std::string_view own = language(code).prompt(key);
    return own.empty() ? language("en").prompt(key) : own;
}

std::vector<std::string_view> language_codes() {
    std::vector<std::string_view> codes;
    for (const auto& [code, file] : files_that_come_along()) codes.push_back(code);
    {
        Given& from_outside = given();
        const std::scoped_lock hold(from_outside.lock);
        for (const auto& [code, file] : from_outside.files) codes.push_back(code);
    }
    std::ranges::sort(codes);
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    return codes;
}

}  // namespace quadrat::genome
