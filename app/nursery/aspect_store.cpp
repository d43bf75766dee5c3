// SPDX-License-Identifier: Apache-2.0
#include "nursery/aspect_store.hpp"

#include <utility>

namespace quadrat::nursery {

bool AspectStore::want(const AspectKey& key) {
    const auto found = kept_.find(key);
    if (found == kept_.end()) return false;
    found->second.wanted = now_;
    return true;
}

void AspectStore::keep(const AspectKey& key, std::uint64_t wanted, Grown grown) {
    kept_[key] = {wanted, std::move(grown)};
}

void AspectStore::forget_old(std::size_t left, const std::function<bool(const AspectKey&)>& is_needed) {
    while (kept_.size() > left) {
        auto oldest = kept_.end();
        for (auto i = kept_.begin(); i != kept_.end(); ++i) {
            if (is_needed(i->first)) continue;
            if (oldest == kept_.end() || i->second.wanted < oldest->second.wanted) oldest = i;
        }
        if (oldest == kept_.end()) return;
        kept_.erase(oldest);
    }
}

}  // namespace quadrat::nursery
