// SPDX-License-Identifier: Apache-2.0
#include "staff/keepsakes.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/log.hpp"
#include "pictures/png_picture.hpp"

namespace quadrat::staff {
namespace {

namespace fs = std::filesystem;

fs::path file_of(const fs::path& folder, std::size_t number) {
    return folder / fmt::format("landscape-{}.png", number + 1);
}

}  // namespace

Keepsakes::Keepsakes(const fs::path& state) : folder_(state / "earlier") {
    std::error_code error;
    fs::file_time_type oldest = fs::file_time_type::max();
    for (std::size_t i = 0; i < kKept; ++i) {
        const fs::path file = file_of(folder_, i);
        const auto written = fs::last_write_time(file, error);
        const auto age = error ? fs::file_time_type::min() : written;
        if (age < oldest) {
            oldest = age;
            next_ = i;
        }
        if (error) continue;
        try {
            images_.push_back(pictures::read_png_quickly(file));
        } catch (const base::InputError& damaged) {
            base::log::debug("earlier landscapes: {}", damaged.what());
        }
    }
}

const mesh::Image* Keepsakes::at(base::Instant now) const {
    if (images_.empty()) return nullptr;
    constexpr base::Instant kEach = std::chrono::seconds{30};
    return &images_[static_cast<std::size_t>(now / kEach) % images_.size()];
}

fs::path Keepsakes::keep(base::Instant now) {
    kept_at_ = now;
    return file_of(folder_, std::exchange(next_, (next_ + 1) % kKept));
}

mesh::Image halved(const mesh::Image& image) {
    mesh::Image half(image.width / 2, image.height / 2, 4);
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x) {
            std::uint8_t* to = half.pixel(x, y);
            for (int c = 0; c < 3; ++c) {
                const int sum = image.pixel(2 * x, 2 * y)[c] + image.pixel(2 * x + 1, 2 * y)[c] +
                                image.pixel(2 * x, 2 * y + 1)[c] + image.pixel(2 * x + 1, 2 * y + 1)[c];
                to[c] = static_cast<std::uint8_t>((sum + 2) / 4);
            }
            to[3] = 255;
        }
    return half;
}

}  // namespace quadrat::staff
