// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "desk/curator.hpp"
#include "genome/words.hpp"
#include "site/configuration.hpp"

// What several of the curator's forms have in common: their fields, and what is written in them.
namespace quadrat::commands {

using desk::Entry;
using desk::Fields;
using desk::Form;
using desk::Group;
using desk::Texts;
using Kind = Entry::Kind;

// Without the spaces around it; "" where nothing is written.
std::string value_in(const Fields& fields, const std::string& name);
// Nothing where nothing is written. Throws InputError, by its label, for what is no number.
std::optional<double> number_in(const Fields& fields, const std::string& name, const std::string& label);

std::vector<desk::Option> language_options();
// The same form in each language; `path` ends in "?" or "&".
std::vector<desk::Option> languages_beside(const std::string& path);
// The language of a form's texts; the site's where none is named.
std::string spoken_in(const Fields& query, const site::Configuration& now);

// Of an aspect's words, in the page's language where the screen speaks it too, else in English.
Group words_of(genome::Aspect aspect, const std::map<std::string, std::array<double, 2>>& words, const Texts& say);
// One end alone limits that end.
std::optional<std::array<double, 2>> range_in(const Fields& fields, std::string_view word);

Group locks(const std::vector<std::string>& locked, const Texts& say);
std::vector<std::string> locked_in(const Fields& fields);

Group texts_of(const std::string& code, const std::map<std::string, std::string>& own, const Texts& say);
// By their keys; those that were left empty are not there.
std::map<std::string, std::string> texts_in(const Fields& form);

}  // namespace quadrat::commands
