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
    std::string from;  // the exhibit in which it was bred; "": this one
    std::filesystem::file_time_type at{};
};

// In the runtime folder: what was bred lately, for whoever chooses among it. In memory, for a disk need not bear it.
inline constexpr const char* kBredLately = "bred";
inline constexpr std::size_t kMostBredLately = 12;
// In the state folder: what was chosen.
inline constexpr const char* kCollection = "collection";
// There too: what other exhibits share.
inline constexpr const char* kGuests = "guests";

// Beside what was bred lately: a postcard of each, ID.card.png, for staff to hand out.
inline constexpr const char* kPostcard = ".card.png";

std::string id_of_landscape(std::string_view code);

// Newest first; none where there is no such folder.
std::vector<KeptLandscape> landscapes_in(const std::filesystem::path& folder);

// What follows says of one of another exhibit that it is here; with its picture, once that has come. Throws InputError.
void keep_guest(const std::filesystem::path& folder, const std::string& code, const std::string& from);
// PNG of a modest size, from anybody: it is drawn anew, so that what lies there is nothing but its picture. Throws
// InputError.
void keep_picture_of_guest(const std::filesystem::path& folder, const std::string& code, const std::string& bytes);

// In place of the oldest, where there are more than `most`. Throws InputError.
void keep_landscape(const std::filesystem::path& folder, const mesh::Image& picture, const std::string& code,
                    std::size_t most);

}  // namespace quadrat::staff
