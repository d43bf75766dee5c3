// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "breeding/breeder.hpp"
#include "exhibit/visit.hpp"
#include "nursery/gallery.hpp"
#include "site/configuration.hpp"

// What the site's settings mean for the visit and for breeding.
namespace quadrat::kiosk {

exhibit::Timings timings_of(const site::Configuration& configuration);
std::vector<genome::Aspect> locked_in(const site::Configuration& configuration);
breeding::BreederOptions breeder_options_of(const site::Configuration& configuration);
nursery::Chosen chosen_by(const site::Configuration& configuration);

}  // namespace quadrat::kiosk
