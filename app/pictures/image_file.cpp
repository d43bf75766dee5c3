// SPDX-License-Identifier: Apache-2.0
#include "pictures/image_file.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "pictures/images/module.hpp"

namespace quadrat::pictures {
namespace {

// Beside the program: PREFIX/bin/quadrat has PREFIX/lib/quadrat/images.so, installed or not.
std::filesystem::path module_file() {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    return program.parent_path().parent_path() / "lib" / "quadrat" / "images.so";
}

const ImageFiles* load() {
    // Never closed: what it brings with it does not survive that.
    void* module = ::dlopen(module_file().c_str(), RTLD_NOW | RTLD_LOCAL);
    using Entry = const ImageFiles* (*)();
    auto* entry = module == nullptr ? nullptr : reinterpret_cast<Entry>(::dlsym(module, "quadrat_image_files"));
    if (entry == nullptr)
        throw base::InputError(fmt::format("pictures can be neither read nor written: {}", ::dlerror()));
    return entry();
}

const ImageFiles& files() {
    static const ImageFiles* const loaded = load();  // tried again where it failed
    return *loaded;
}

PictureName named(const std::filesystem::path& path) { return {path.string(), base::ending_of(path)}; }

std::string bytes_of(const std::filesystem::path& path) {
    constexpr std::size_t kLargest = std::size_t{2} << 30U;
    return base::read_file(path, kLargest);
}

}  // namespace

std::string encoded_picture(const std::filesystem::path& name, const mesh::Image& pixels, const std::string& json) {
    return files().encode_picture(named(name), pixels, json);
}

std::string encoded_field(const std::filesystem::path& name, const mesh::Field& field) {
    return files().encode_field(named(name), field);
}

std::string encoded_heights(const std::filesystem::path& name, const mesh::Field& field, float low, float high) {
    return files().encode_heights(named(name), field, low, high);
}

GreyPicture read_grey_picture(const std::filesystem::path& path) {
    return files().read_grey(bytes_of(path), path.string());
}

mesh::Image read_image_file(const std::filesystem::path& path) { return files().read(bytes_of(path), path.string()); }

bool is_image_file(std::string_view bytes) {
    return bytes.starts_with("\x89PNG") || bytes.starts_with("\x76\x2f\x31\x01");
}

std::optional<std::string> scene_inside(const std::filesystem::path& path) {
    return files().scene_inside(bytes_of(path), path.string());
}

}  // namespace quadrat::pictures
