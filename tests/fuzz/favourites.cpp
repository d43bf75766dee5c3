// SPDX-License-Identifier: Apache-2.0
// What anybody may send by a broker as an exhibit's favourites, or as the picture of one: it is refused whole, or what
// is taken of it are a few landscapes as this program writes them.
#include "fleet/favourites.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/error.hpp"
#include "genome/scene_code.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat;
    const std::string text(reinterpret_cast<const char*>(bytes), size);
    if (fleet::trouble_of_picture(text).empty() && size > fleet::kLargestPicture) std::abort();
    fleet::Guests guests("hall-1");
    guests.hear("hall-2", text);
    guests.look({});
    try {
        const auto favourites = fleet::favourites_from(text);
        if (favourites.size() > fleet::kMostShared || guests.chosen().size() != favourites.size()) std::abort();
        for (const fleet::Favourite& one : favourites)
            if (genome::code_of(genome::recipe_of_code(one.code, "it")) != one.code) std::abort();
        if (!favourites.empty() && fleet::favourites_from(fleet::to_text(favourites)) != favourites) std::abort();
    } catch (const base::InputError&) {
        if (!guests.chosen().empty()) std::abort();
    }
    return 0;
}
