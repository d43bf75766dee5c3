// SPDX-License-Identifier: Apache-2.0
#include "render/code_picture.hpp"

#include <qrencode.h>

#include <algorithm>
#include <memory>

namespace quadrat::render {
namespace {

constexpr int kQuietModules = 4;

struct FreeCode {
    void operator()(QRcode* code) const { QRcode_free(code); }
};

}  // namespace

mesh::Image code_picture(const std::string& text, int most_px) {
    const std::unique_ptr<QRcode, FreeCode> code(QRcode_encodeString(text.c_str(), 0, QR_ECLEVEL_L, QR_MODE_8, 1));
    const int modules = code ? code->width + 2 * kQuietModules : 0;
    const int module_px = modules > 0 ? most_px / modules : 0;
    if (module_px < 1) return {};
    mesh::Image image(modules * module_px, modules * module_px, 4);
    std::ranges::fill(image.bytes, std::uint8_t{255});
    for (int y = 0; y < code->width; ++y)
        for (int x = 0; x < code->width; ++x) {
            if ((code->data[y * code->width + x] & 1U) == 0) continue;
            for (int row = 0; row < module_px; ++row) {
                std::uint8_t* first =
                    image.pixel((x + kQuietModules) * module_px, (y + kQuietModules) * module_px + row);
                for (int column = 0; column < module_px; ++column) std::fill_n(first + 4 * column, 3, std::uint8_t{0});
            }
        }
    return image;
}

}  // namespace quadrat::render
