// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "desk/pages.hpp"

// What all pages have around their content.
namespace quadrat::desk {

// A whole page. `key`: of its title among the texts.
std::string page(const View& view, const std::string& key, const std::string& body);

// A form of one button, that does an act.
std::string act_button(const View& view, const std::string& act, const std::string& classes = "");
std::string token_field(const View& view);

// What the program itself says, in English on every page.
std::string program_words(const View& view, const std::string& words);

}  // namespace quadrat::desk
