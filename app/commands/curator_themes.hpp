// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "desk/curator.hpp"
#include "site/curation.hpp"

// A site's themes as a list, from which one may be chosen, and each as a form of its own.
namespace quadrat::commands {

desk::Form themes_form(const site::Configuration& now, const desk::Texts& say);
desk::Form theme_form(const desk::Fields& query, const site::Configuration& now, const desk::Texts& say);
// Throws InputError: it has no name, or another's, or is the site's to take out.
std::vector<site::Edit> theme_edits(const desk::Fields& fields, desk::Curator::Deed deed,
                                    const site::Configuration& now, const site::Configuration& site);

}  // namespace quadrat::commands
