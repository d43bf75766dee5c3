// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "desk/curator.hpp"
#include "site/curation.hpp"

// The parts of what a curator may say: each as a form with what holds now, and as edits from what was written in it.
namespace quadrat::commands {

std::vector<std::string> curator_parts();

// Nothing: there is no such part.
std::optional<desk::Form> curator_form(const std::string& part, const desk::Fields& query, const desk::Texts& say,
                                       const site::Configuration& now);

// `site`: what would hold without the curator. Throws InputError: what was written means nothing. Whether it is right,
// site::Curation knows.
std::vector<site::Edit> curator_edits(const std::string& part, const desk::Fields& form, desk::Curator::Deed deed,
                                      const site::Configuration& now, const site::Configuration& site);

}  // namespace quadrat::commands
