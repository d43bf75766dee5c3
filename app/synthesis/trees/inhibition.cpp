// SPDX-License-Identifier: Apache-2.0
// Douady & Couder, "Phyllotaxis as a dynamical self organizing process", part II (Journal of Theoretical Biology 1996):
// a leaf begins when and where the inhibition by those before it falls below a threshold; and Smith et al., "Inhibitory
// fields" (Canadian Journal of Botany 2006), who get every pattern so. Ours is on a cylinder: a leaf at distance d
// inhibits by (Γ / d)^6, and the threshold is 1. As Γ falls, patterns come in the order that both papers give.
#include "synthesis/trees/inhibition.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrat::synthesis::trees {
namespace {

constexpr int kPlaces = 144;  // around the shoot, between which a leaf's own place is worked out
constexpr float kTurn = 6.2831853F;
constexpr float kStep = 0.012F;  // by which the shoot grows at a time, of Γ
constexpr float kFar = 3;        // of Γ: a leaf farther below inhibits no more
constexpr int kSettled = 24;     // leaves after which the pattern is its own

struct Young {
    float turn, cosine, sine, height;
};

class Meristem {
  public:
    explicit Meristem(float gamma) : gamma_(gamma) {
        for (int k = 0; k < kPlaces; ++k) {
            const float turn = kTurn * static_cast<float>(k) / kPlaces;
            cosine_[k] = std::cos(turn);
            sine_[k] = std::sin(turn);
        }
    }

    std::vector<Young> grow(std::size_t count) {
        std::vector<Young> all;
        for (float height = 0; all.size() < count; height += kStep * gamma_) {
            for (int at_once = 0; at_once < kPlaces && all.size() < count; ++at_once) {
                const float turn = freest(all, height);
                if (turn < 0) break;
                all.push_back({turn, std::cos(turn), std::sin(turn), height});
            }
        }
        return all;
    }

  private:
    // Where a leaf can begin now, -1: nowhere.
    float freest(const std::vector<Young>& all, float height) {
        inhibition_.fill(0);
        for (std::size_t i = all.size(); i-- > 0;) {
            const Young& leaf = all[i];
            const float up = height - leaf.height;
            if (up > kFar * gamma_) break;
            for (int k = 0; k < kPlaces; ++k) {
                const float d2 = 2 - 2 * (cosine_[k] * leaf.cosine + sine_[k] * leaf.sine) + up * up;
                const float near = gamma_ * gamma_ / std::max(d2, 1.0e-4F);
                inhibition_[k] += near * near * near;
            }
        }
        const auto least =
            static_cast<int>(std::min_element(inhibition_.begin(), inhibition_.end()) - inhibition_.begin());
        if (inhibition_[least] >= 1) return -1;
        // Between places: the bottom of the parabola through three of them.
        const float before = inhibition_[(least + kPlaces - 1) % kPlaces];
        const float after = inhibition_[(least + 1) % kPlaces];
        const float bend = before + after - 2 * inhibition_[least];
        const float off = bend > 1.0e-6F ? std::clamp(0.5F * (before - after) / bend, -0.5F, 0.5F) : 0.0F;
        const float turn = kTurn * (static_cast<float>(least) + off) / kPlaces;
        return turn < 0 ? turn + kTurn : turn;
    }

    float gamma_;
    std::array<float, kPlaces> cosine_{}, sine_{}, inhibition_{};
};

}  // namespace

std::vector<Primordium> leaves_of_shoot(float gamma, int count) {
    const auto wanted = static_cast<std::size_t>(std::max(count, 0));
    const std::vector<Young> all =
        Meristem(std::clamp(gamma, kLeastInhibition, kMostInhibition)).grow(kSettled + wanted);
    std::vector<Primordium> leaves;
    for (std::size_t i = kSettled; i < all.size(); ++i)
        leaves.push_back({all[i].turn, all.back().height - all[i].height});
    return leaves;
}

float inhibition_of(float share) {
    return kLeastInhibition + (kMostInhibition - kLeastInhibition) * std::clamp(share, 0.0F, 1.0F);
}

}  // namespace quadrat::synthesis::trees
