// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

#include "site/configuration_reader.hpp"

// Settings of two layers: the site's file, and over it the one that its curator writes at the desk.
namespace quadrat::site {

// Both in one text, so that what is kept as the last that worked is both: the site's file byte for byte, a line that
// names the other file, and that file. Where `above` is "" the text is `below`.
std::string laid_over(std::string_view below, std::string_view above, std::string_view above_source);

struct Layers {
    std::string_view below, above;  // of the text; `above` is "" where there is one layer
    std::string above_source;
};
Layers layers_of(std::string_view toml);

// Puts what `above` says in the place of what `below` says of the same: key by key, within [text] a level deeper. Whole
// tables give way where a part of them would mean something else: opening hours, themes. Notes a mistake for each table
// that is not the curator's to say.
void lay_over(toml::table& below, toml::table above, const std::string& above_source, std::vector<Mistake>& mistakes);

}  // namespace quadrat::site
