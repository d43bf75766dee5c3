// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "commands/desk_sources.hpp"
#include "desk/curator.hpp"
#include "site/mistake.hpp"

namespace quadrat::commands {

// What the curator may say, as forms, and what comes of them: the curator's file over the site's (site/curation.hpp).
desk::Curator curator_of(const DeskPlaces& places);

// What was said that cannot be. Lines of the site's file are left out: whoever reads this may not reach it.
std::string in_one_line(const site::SettingsError& error);

}  // namespace quadrat::commands
