// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>

#include "desk/http.hpp"
#include "desk/pages.hpp"

// The curator's half of the desk: what is asked for, and what is said, by whoever has a session.
namespace quadrat::desk {

bool is_curators(std::string_view path);

// A page to read. `view` has the request's path and what a form of ours needs.
Answer curated(const Request& request, View view);

// What a form of ours said, whose token was right.
Answer curate(const Request& request, const View& view);

}  // namespace quadrat::desk
