// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/image.hpp"

namespace quadrat::staff {

// A landscape that visitors bred, with a small picture of it, in a folder of such: ID.png beside ID.code.
struct KeptLandscape {
    std::string id;    // 16 hexadecimal digits, of its code
    std::string code;  // genome/scene_code.hpp
    std::filesystem::file_time_type at{};
};

// In the runtime folder: what was bred lately, for whoever chooses among it. In memory, for a disk need not bear it.
inline constexpr const char* kBredLately = "bred";
inline constexpr std::size_t kMostBredLately = 12;
// In the state folder: what was chosen.
inline constexpr const char* kCollection = "collection";

std::string id_of_landscape(std::string_view code);

// Newest first; none where there is no such folder.
std::vector<KeptLandscape> landscapes_in(const std::filesystem::path& folder);

// In place of the oldest, where there are more than `most`. Throws InputError.
void keep_landscape(const std::filesystem::path& folder, const mesh::Image& picture, const std::string& code,
                    std::size_t most);

}  // namespace quadrat::staff
