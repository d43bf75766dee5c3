// SPDX-License-Identifier: Apache-2.0
#include "kiosk/image_file.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "kiosk/images/module.hpp"

namespace quadrat::kiosk {
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

}  // namespace

void write_image_file(const std::filesystem::path& path, const std::string& name, const mesh::Image& pixels,
                      const std::string& json) {
    files().write(path, name, pixels, json);
}

void write_field_file(const std::filesystem::path& path, const std::string& name, const mesh::Field& field) {
    files().write_field(path, name, field);
}

std::size_t write_height_picture(const std::filesystem::path& path, const std::string& name, const mesh::Field& field,
                                 float low, float high) {
    return files().write_heights(path, name, field, low, high);
}

mesh::Field read_mask_file(const std::filesystem::path& path) { return files().read_mask(path); }

mesh::Image read_image_file(const std::filesystem::path& path) { return files().read(path); }

bool is_image_file(std::string_view bytes) {
    return bytes.starts_with("\x89PNG") || bytes.starts_with("\x76\x2f\x31\x01");
}

std::optional<std::string> scene_inside(const std::filesystem::path& path) { return files().scene_inside(path); }

}  // namespace quadrat::kiosk
