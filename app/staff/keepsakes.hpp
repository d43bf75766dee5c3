// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/clock.hpp"
#include "mesh/image.hpp"

namespace quadrat::staff {

// Small pictures of landscapes that visitors bred, kept on disk: what is shown where nothing has grown yet, and in safe
// mode. Few and seldom, for the sake of the disk: three of them, a new one every three hours at most.
class Keepsakes {
  public:
    static constexpr std::size_t kKept = 3;
    static constexpr base::Instant kEvery = std::chrono::hours{3};

    Keepsakes() = default;  // keeps none
    // Reads what is there; what cannot be read is left out.
    explicit Keepsakes(const std::filesystem::path& state);

    // The one to show at a moment, each for half a minute; null without any.
    const mesh::Image* at(base::Instant now) const;

    bool wants_another(base::Instant now) const { return !folder_.empty() && (!kept_at_ || now - *kept_at_ >= kEvery); }
    // Where the next one goes, in place of the oldest. The picture is for the file alone.
    std::filesystem::path keep(base::Instant now);

  private:
    std::filesystem::path folder_;
    std::vector<mesh::Image> images_;
    std::optional<base::Instant> kept_at_;
    std::size_t next_ = 0;
};

// Half as wide and half as high, opaque.
mesh::Image halved(const mesh::Image& image);

}  // namespace quadrat::staff
