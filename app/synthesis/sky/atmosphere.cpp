// SPDX-License-Identifier: Apache-2.0
// Hillaire 2020, sections 5.2 (transmittance), 5.5 (multiple scattering: his equations 5 to 10). Ours keeps columns of
// matter instead of transmittances: they do not depend on the genes and are worked out once.
#include "synthesis/sky/atmosphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

namespace quadrat::synthesis::sky {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kGround_m = 6360e3F;
constexpr float kTop_m = 80e3F;  // of the air, above the ground
constexpr float kEye_m = 200.0F;
constexpr float kRayleighScale_m = 8000.0F;
constexpr float kHazeScale_m = 1200.0F;
constexpr glm::vec3 kRayleigh_per_m{5.802e-6F, 13.558e-6F, 33.1e-6F};
constexpr glm::vec3 kOzone_per_m{0.650e-6F, 1.881e-6F, 0.085e-6F};
constexpr float kHazeAbsorbed = 0.1F;  // of what haze takes

// Relative densities of air, haze and ozone; ozone lies in a layer of 15 to 40 km.
glm::vec3 densities(float height_m) {
    return {std::exp(-height_m / kRayleighScale_m), std::exp(-height_m / kHazeScale_m),
            std::max(0.0F, 1.0F - std::abs(height_m - 25e3F) / 15e3F)};
}

// Along a ray from a height, rising by mu = the cosine of its zenith angle: how far to the top, and to the ground.
float to_top_m(float height_m, float mu) {
    // (r mu)^2 + (R_top^2 - r^2) without the squares of millions in single precision.
    const float r = kGround_m + height_m;
    const float apart = (kTop_m - height_m) * (2.0F * kGround_m + kTop_m + height_m);
    const float s = std::sqrt(r * r * mu * mu + apart);
    return mu > 0 ? apart / (s + r * mu) : s - r * mu;
}

bool meets_ground(float height_m, float mu) {
    if (mu >= 0) return false;
    const float r = kGround_m + height_m;
    return height_m * (2.0F * kGround_m + height_m) <= r * r * mu * mu;
}

float height_along(float height_m, float mu, float s) {
    const float r = kGround_m + height_m;
    const float squared = s * (s + 2.0F * r * mu) + r * r;
    return std::max((s * (s + 2.0F * r * mu)) / (std::sqrt(std::max(squared, 1.0F)) + r) + height_m, 0.0F);
}

glm::vec3 column_of(float height_m, float mu) {
    constexpr int kSteps = 40;
    const float length = to_top_m(height_m, mu);
    glm::vec3 sum{0};
    // Steps grow with the distance: most of the air lies near.
    for (int i = 0; i < kSteps; ++i) {
        const float a = static_cast<float>(i) / kSteps;
        const float b = static_cast<float>(i + 1) / kSteps;
        const float s = 0.5F * (a * a + b * b) * length;
        sum += densities(height_along(height_m, mu, s)) * ((b * b - a * a) * length);
    }
    return sum;
}

// Columns of matter, m at the ground's density, from a height to the top; only for rays that miss the ground.
class Columns {
  public:
    static const Columns& all() {
        static const Columns columns;
        return columns;
    }
    glm::vec3 at(float height_m, float mu) const {
        const float row = std::sqrt(std::clamp(height_m / kTop_m, 0.0F, 1.0F)) * (kRows - 1);
        const float lowest = horizon(height_m);
        const float t = std::clamp((mu - lowest) / (1.0F - lowest), 0.0F, 1.0F);
        const float column = std::sqrt(t) * (kMus - 1);
        const int x = std::min(static_cast<int>(column), kMus - 2);
        const int y = std::min(static_cast<int>(row), kRows - 2);
        const float tx = column - static_cast<float>(x);
        const float ty = row - static_cast<float>(y);
        const glm::vec3 above = glm::mix(table_.at(x, y), table_.at(x + 1, y), tx);
        return glm::mix(above, glm::mix(table_.at(x, y + 1), table_.at(x + 1, y + 1), tx), ty);
    }

  private:
    static constexpr int kRows = 40;
    static constexpr int kMus = 64;

    static float horizon(float height_m) {
        const float r = kGround_m + height_m;
        return -std::sqrt(std::max(height_m * (2.0F * kGround_m + height_m), 0.0F)) / r;
    }
    Columns() : table_(kMus, kRows) {
        for (int y = 0; y < kRows; ++y) {
            const float up = static_cast<float>(y) / (kRows - 1);
            const float height_m = up * up * kTop_m;
            const float lowest = horizon(height_m);
            for (int x = 0; x < kMus; ++x) {
                const float t = static_cast<float>(x) / (kMus - 1);
                table_.at(x, y) = column_of(height_m, lowest + t * t * (1.0F - lowest));
            }
        }
    }
    mesh::Grid<glm::vec3> table_;
};

// Steps along a ray, longer and longer.
struct March {
    float step_m = 0;
    float at_m = 0;  // the middle of the step

    March(float length_m, int steps) : length_m_(length_m), share_(1.0F / static_cast<float>(steps)), left_(steps) {}
    bool advance() {
        if (left_-- == 0) return false;
        const float share = share_ * static_cast<float>(++taken_);
        const float end_m = share * share * length_m_;
        step_m = end_m - end_m_;
        at_m = 0.5F * (end_m + end_m_);
        end_m_ = end_m;
        return true;
    }

  private:
    float length_m_;
    float share_;
    int left_;
    int taken_ = 0;
    float end_m_ = 0;
};

float rayleigh_phase(float cosine) { return 3.0F / (16.0F * kPi) * (1.0F + cosine * cosine); }

// Cornette & Shanks 1992.
float haze_phase(float cosine, float g) {
    const float g2 = g * g;
    const float d = 1.0F + g2 - 2.0F * g * cosine;
    return 3.0F / (8.0F * kPi) * (1.0F - g2) * (1.0F + cosine * cosine) / ((2.0F + g2) * d * std::sqrt(d));
}

}  // namespace

Atmosphere::Atmosphere(const Air& air) : forward_(air.forward), ground_(air.ground), often_(kSuns, kHeights) {
    rayleigh_ = kRayleigh_per_m * air.molecules;
    ozone_ = kOzone_per_m * air.ozone;
    // Turbidity is a ratio of optical depths, by the green channel and the earth's own air.
    const float haze_depth = (air.turbidity - 1.0F) * kRayleigh_per_m.g * kRayleighScale_m;
    haze_extinction_ = haze_depth / kHazeScale_m;
    haze_scattering_ = haze_extinction_ * (1.0F - kHazeAbsorbed);
    scatter_often();
}

glm::vec3 Atmosphere::extinction(const glm::vec3& c) const {
    return rayleigh_ * c.x + glm::vec3{haze_extinction_ * c.y} + ozone_ * c.z;
}

glm::vec3 Atmosphere::through(float height_m, float mu) const {
    if (meets_ground(height_m, mu)) return glm::vec3{0};
    return glm::exp(-extinction(Columns::all().at(height_m, mu)));
}

glm::vec3 Atmosphere::transmittance(float sun_y) const { return through(kEye_m, sun_y); }

glm::vec3 Atmosphere::many_times(float height_m, float sun_y) const {
    const float row = std::clamp(height_m / kTop_m, 0.0F, 1.0F) * (kHeights - 1);
    const float column = (std::clamp(sun_y, -0.3F, 1.0F) + 0.3F) / 1.3F * (kSuns - 1);
    const int x = std::min(static_cast<int>(column), kSuns - 2);
    const int y = std::min(static_cast<int>(row), kHeights - 2);
    const float tx = column - static_cast<float>(x);
    const glm::vec3 low = glm::mix(often_.at(x, y), often_.at(x + 1, y), tx);
    return glm::mix(low, glm::mix(often_.at(x, y + 1), often_.at(x + 1, y + 1), tx), row - static_cast<float>(y));
}

// For a point: the light that comes there after one scattering, L2, and the share f of isotropic light that is
// scattered back there; all further orders are a geometric series. What lies on a ray is the same for every sun.
void Atmosphere::scatter_often() {
    constexpr int kDirections = 10;
    constexpr int kSteps = 8;
    const auto sun_y_of = [](int x) { return -0.3F + 1.3F * static_cast<float>(x) / (kSuns - 1); };
    for (int y = 0; y < kHeights; ++y) {
        const float height_m = std::max(kTop_m * static_cast<float>(y) / (kHeights - 1), 10.0F);
        std::array<glm::vec3, kSuns> second{};
        glm::vec3 again{0};
        for (int k = 0; k < kDirections; ++k) {
            const float mu = -1.0F + 2.0F * (static_cast<float>(k) + 0.5F) / kDirections;
            const bool is_down = meets_ground(height_m, mu);
            const float r = kGround_m + height_m;
            const float down = r * r * mu * mu - height_m * (2.0F * kGround_m + height_m);
            const float length = is_down ? -r * mu - std::sqrt(std::max(down, 0.0F)) : to_top_m(height_m, mu);
            March march(length, kSteps);
            glm::vec3 left{1};
            while (march.advance()) {
                const float h = height_along(height_m, mu, march.at_m);
                const glm::vec3 density = densities(h);
                const glm::vec3 scattered = rayleigh_ * density.x + glm::vec3{haze_scattering_ * density.y};
                const glm::vec3 passed = glm::exp(-extinction(density) * march.step_m);
                const glm::vec3 taken = (1.0F - passed) / glm::max(extinction(density), glm::vec3{1.0e-12F});
                // Averaged over bearings the sun's height over the sample changes little.
                const glm::vec3 sent = left * scattered * taken;
                for (int x = 0; x < kSuns; ++x) second[x] += sent * through(h, sun_y_of(x)) / (4.0F * kPi);
                again += sent;
                left *= passed;
            }
            if (!is_down) continue;
            for (int x = 0; x < kSuns; ++x)
                second[x] += left * through(0.0F, sun_y_of(x)) * (ground_ * std::max(sun_y_of(x), 0.0F) / kPi);
        }
        again /= static_cast<float>(kDirections);
        for (int x = 0; x < kSuns; ++x)
            often_.at(x, y) = second[x] / static_cast<float>(kDirections) / (1.0F - glm::min(again, glm::vec3{0.95F}));
    }
}

glm::vec3 Atmosphere::radiance(const glm::vec3& direction, const glm::vec3& sun) const {
    const float mu = std::max(direction.y, 0.002F);
    // Toward the horizon air lies longer and changes more.
    const int steps = std::min(6 + static_cast<int>(3.0F / mu), 18);
    const float cosine = glm::dot(direction, sun);
    const float of_air = rayleigh_phase(cosine);
    const float of_haze = haze_phase(cosine, forward_);
    const float length = to_top_m(kEye_m, mu);
    const float r = kGround_m + kEye_m;
    glm::vec3 left{1};
    glm::vec3 sum{0};
    March march(length, steps);
    while (march.advance()) {
        const float h = height_along(kEye_m, mu, march.at_m);
        // The sun's height where the sample lies, over the curved earth.
        const float sun_y = (sun.y * r + march.at_m * cosine) / (kGround_m + h);
        const glm::vec3 density = densities(h);
        const glm::vec3 air = rayleigh_ * density.x;
        const float haze = haze_scattering_ * density.y;
        const glm::vec3 once = through(h, sun_y) * (air * of_air + glm::vec3{haze * of_haze});
        const glm::vec3 often = many_times(h, sun_y) * (air + glm::vec3{haze});
        const glm::vec3 taken_per_m = glm::max(extinction(density), glm::vec3{1.0e-12F});
        const glm::vec3 passed = glm::exp(-taken_per_m * march.step_m);
        sum += left * (once + often) * (1.0F - passed) / taken_per_m;
        left *= passed;
    }
    return sum;
}

}  // namespace quadrat::synthesis::sky
