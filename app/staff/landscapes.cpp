// SPDX-License-Identifier: Apache-2.0
#include "staff/landscapes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/seed.hpp"
#include "pictures/picture.hpp"
#include "pictures/png_picture.hpp"

namespace quadrat::staff {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 480;
constexpr std::size_t kLongestCode = 4096;
constexpr std::string_view kFrom = "\nfrom ";

}  // namespace

std::string id_of_landscape(std::string_view code) { return fmt::format("{:016x}", base::Seed{}.child(code).value); }

std::vector<KeptLandscape> landscapes_in(const fs::path& folder) {
    std::vector<KeptLandscape> all;
    std::error_code error;
    for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
        if (file->path().extension() != ".code") continue;
        try {
            const std::string text = base::read_file(file->path(), kLongestCode);
            const std::size_t line = std::min(text.find('\n'), text.size());
            KeptLandscape one{file->path().stem().string(), text.substr(0, line), "", {}};
            if (text.substr(line).starts_with(kFrom)) {
                one.from = text.substr(line + kFrom.size());
                one.from = one.from.substr(0, one.from.find('\n'));
            }
            one.at = fs::last_write_time(file->path(), error);
            if (one.id == id_of_landscape(one.code)) all.push_back(std::move(one));
        } catch (const base::InputError&) {
            continue;  // it went away meanwhile
        }
    }
    std::ranges::sort(all, [](const auto& a, const auto& b) { return a.at != b.at ? a.at > b.at : a.id < b.id; });
    return all;
}

void keep_guest(const fs::path& folder, const std::string& code, const std::string& from) {
    std::error_code error;
    fs::create_directories(folder, error);
    base::write_file(folder / (id_of_landscape(code) + ".code"), fmt::format("{}{}{}\n", code, kFrom, from));
}

void keep_picture_of_guest(const fs::path& folder, const std::string& code, const std::string& bytes) {
    const fs::path file = folder / (id_of_landscape(code) + ".png");
    const fs::path foreign = folder / (id_of_landscape(code) + ".foreign");
    base::write_file(foreign, bytes);
    std::error_code error;
    try {
        const mesh::Image picture = pictures::read_png_quickly(foreign);
        pictures::write_png_quickly(file, picture.width > kWidth ? pictures::scaled_to(picture, kWidth) : picture);
    } catch (const base::InputError&) {
        fs::remove(foreign, error);
        throw base::InputError("its picture cannot be read");
    }
    fs::remove(foreign, error);
}

void keep_landscape(const fs::path& folder, const mesh::Image& picture, const std::string& code, std::size_t most) {
    std::error_code error;
    fs::create_directories(folder, error);
    const std::string id = id_of_landscape(code);
    pictures::write_png_quickly(folder / (id + ".png"),
                                picture.width > kWidth ? pictures::scaled_to(picture, kWidth) : picture);
    base::write_file(folder / (id + ".code"), code + "\n");
    const auto all = landscapes_in(folder);
    for (std::size_t i = most; i < all.size(); ++i)
        for (const char* extension : {".code", ".png", kPostcard}) fs::remove(folder / (all[i].id + extension), error);
}

}  // namespace quadrat::staff
