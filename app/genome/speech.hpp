// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "genome/parameter_table.hpp"
#include "genome/words.hpp"

namespace quadrat::genome {

// What the screen asks and says, and what is heard alone (hear.again), by key.
inline constexpr std::array<std::string_view, 33> kPrompts{
    "attract",    "ask.language", "ask.trees",      "ask.land",      "ask.sky",      "breed",     "still-there",
    "finale",     "first",        "describe.trees", "describe.land", "describe.sky", "slide",     "back",
    "invite.one", "invite.two",   "hold.one",       "hold.two",      "scan.one",     "scan.step", "scan.two",
    "scan.rest",  "hear.again",   "take-home",      "closed",        "settings",     "turns",     "family",
    "go-on",      "print",        "printing",       "done",          "breed-on"};

// A number for each parameter of the table, in its order.
using ParameterShares = std::vector<float>;

// How one language speaks of a Description: an adjective for each end of each word, agreeing with its aspect's noun,
// and the templates that join them. Data: genome/languages/*.json, inside the binary.
class Language {
  public:
    // Throws InputError naming source and the key. A word or a detail left out is spoken in English; so is a prompt.
    static Language from_json(std::string_view json, std::string_view source);

    const std::string& name() const { return name_; }  // in itself: "Deutsch"
    bool reads_right_to_left() const;                  // as its name does

    // "steep and wet land; sparse tall trees; a red sky": for each aspect the two strongest of its words, if any is
    // strong enough to notice.
    std::string describe(const Description& description) const;
    std::string describe(const Description& description, Aspect aspect) const;

    // The same of one of several that are compared by ear: where another would be described alike, the word in which it
    // differs most from those comes after it. `which` has a description.
    std::string describe_among(std::span<const std::optional<Description>> all, std::size_t which, Aspect aspect) const;

    // What changed most for an aspect from one to the other, as its two adjectives at most: "tall, sparse"; "" if
    // nothing did that one would notice.
    std::string heredity(const Description& from, const Description& to, Aspect aspect) const;

    // What moved most for an aspect of what no word speaks of: "wider crowns"; "" where nothing did that one would
    // notice. How far parameters went is told as shares of their ranges.
    std::string detail(const ParameterShares& moved, Aspect aspect) const;

    // What less or more of a parameter is called; "" for one that nobody would name.
    std::string_view detail(ParameterId id, bool is_more) const;

    // The four answers to which words suit an aspect, from the word's low end: "dry land", "rather dry land", …
    std::array<std::string, 4> answers(WordId id) const;

    // "" where this language has none for the key, one of kPrompts.
    std::string_view prompt(std::string_view key) const;

    std::string_view end(WordId id, bool is_high) const { return ends_[static_cast<std::size_t>(id)][is_high ? 1 : 0]; }

  private:
    struct Phrase {
        std::string with;   // "{} trees"
        std::string plain;  // when no word stands out
    };
    std::string adjective(WordId id, float value) const;

    std::string name_;
    std::string sentence_;
    std::string and_;
    std::string very_;
    std::string rather_;
    PerAspect<Phrase> phrases_;
    std::array<std::array<std::string, 2>, kWordCount> ends_;
    std::map<ParameterId, std::array<std::string, 2>> details_;
    std::map<std::string, std::string, std::less<>> prompts_;
};

// By code ("en", "de", "ar", …, "de-AT", "fr_CA.UTF-8"); English for one that is not spoken.
const Language& language(std::string_view code);
std::vector<std::string_view> language_codes();  // sorted

// The file of a language, or what was given in its place; "" for a code that is not spoken.
std::string_view language_json(std::string_view code);

// From now on a language is spoken as this file says, before the one that comes along. Throws InputError as
// Language::from_json does. A code keeps the first file that it was given until the program ends: who speaks may hold
// on to it. May be called by any thread.
void speak_from(const std::string& code, std::string json, std::string_view source);

// The same for each CODE.json and CODE.po of a folder.
void speak_from_folder(const std::filesystem::path& folder);

// What the screen says for a key of kPrompts, in the language of the code or, where that has none, in English.
std::string_view prompt(std::string_view code, std::string_view key);

}  // namespace quadrat::genome
