// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "base/seed.hpp"
#include "firmware-io/button_source.hpp"

namespace quadrat::commands {

// A visitor for when nobody is there to press: comes, answers so many rounds with likings of their own, watches the
// finale and goes. Everything follows from the seed.
std::unique_ptr<firmware_io::ButtonSource> scripted_visitor(int rounds, base::Seed seed);

}  // namespace quadrat::commands
