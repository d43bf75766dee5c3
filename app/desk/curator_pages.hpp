// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "desk/curator.hpp"
#include "desk/pages.hpp"

namespace quadrat::desk {

// What all parts have been brought to, and the way back.
std::string curator_page(const View& view);

// A part. `posted`: what was written and could not be taken, which stays in the fields; `trouble`: why; "" for none.
struct Posted {
    const Fields* fields = nullptr;
    std::string trouble = {};
    std::string previewed = {};  // the entry that is to be seen as the exhibit draws it
};
std::string form_page(const View& view, const Form& form, const Posted& posted);

}  // namespace quadrat::desk
