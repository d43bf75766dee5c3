// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <map>

#include "nursery/plot.hpp"

namespace quadrat::nursery {

// Grown aspects, by what they were grown from; those that were wanted last are kept.
class AspectStore {
  public:
    // From now on everything that is wanted is wanted later than what was before.
    void pass_time() { ++now_; }
    std::uint64_t now() const { return now_; }

    // True where it is there.
    bool want(const AspectKey& key);
    void keep(const AspectKey& key, std::uint64_t wanted, Grown grown);
    bool contains(const AspectKey& key) const { return kept_.contains(key); }
    std::size_t size() const { return kept_.size(); }

    // Null where there is none. The aspect of the key must be the one that is asked for.
    std::shared_ptr<const scene::Flora> flora(const AspectKey& key) const { return found<0>(key); }
    std::shared_ptr<const scene::Land> land(const AspectKey& key) const { return found<1>(key); }
    std::shared_ptr<const scene::Sky> sky(const AspectKey& key) const { return found<2>(key); }

    // The oldest go until so many are left, or only what is needed.
    void forget_old(std::size_t left, const std::function<bool(const AspectKey&)>& is_needed);

  private:
    struct Kept {
        std::uint64_t wanted;  // when, last
        Grown grown;
    };
    template <std::size_t kWhich>
    std::variant_alternative_t<kWhich, Grown> found(const AspectKey& key) const {
        const auto at = kept_.find(key);
        if (at == kept_.end()) return nullptr;
        return std::get<kWhich>(at->second.grown);
    }

    std::uint64_t now_ = 0;
    std::map<AspectKey, Kept> kept_;
};

}  // namespace quadrat::nursery
