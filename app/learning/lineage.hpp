// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "archive/archive.hpp"
#include "breeding/session.hpp"
#include "learning/school.hpp"

namespace quadrat::learning {

// How landscapes are bred here.
struct Rules {
    breeding::BreederOptions breeder;  // with the map and the taste of now
    int control_every = 0;             // one of so many visits is bred by chance alone; 0: none
    std::vector<genome::Aspect> locked;
};

// Which visits are bred by chance hangs on their seeds: one that is taken up after a power cut goes on as it was.
breeding::BreederOptions options_of_visit(breeding::BreederOptions options, int control_every, base::Seed session);

// What one visit breeds, and what was done for it: enough to breed it again.
class Lineage {
  public:
    explicit Lineage(breeding::Session session) : session_(std::move(session)) {}

    const breeding::Session& session() const { return session_; }

    void next(const genome::Pick& answers);
    void finish(const genome::Pick& answers) { session_.next(answers); }  // nothing comes after it
    void slide(int slider, int direction);  // throws InputError where there is no such slider
    void undo();
    // Begins with what follows from a landscape that is liked, by its code. Throws InputError naming what is no code.
    void begin_with(const std::string& liked);
    std::string liked() const { return deeds_.empty() ? "" : deeds_.front().liked; }  // "": it began with none
    // Goes on from a node of the session's tree, to which these picks lead from the first four that were offered.
    void return_to(int node, const std::vector<genome::Pick>& picks);

    // As it is kept, after these answers of the round under way; its visit is for who keeps it.
    archive::Generation generation(const genome::Pick& answers) const;

  private:
    breeding::Session session_;
    std::vector<archive::Deed> deeds_;  // from its first four to those of now
};

// The lineage of the visit, or of the one to come; and, once that is prepared, of a visit that may go on yet.
struct Lineages {
    std::optional<Lineage> now;
    std::optional<Lineage> left;

    void prepare(Lineage next) { left = std::exchange(now, std::move(next)); }
    void go_on_with_left() {
        if (left) now = std::exchange(left, std::nullopt);
    }
    // Of the two, what a visitor has bred; or null.
    const Lineage* bred() const { return left ? &*left : now ? &*now : nullptr; }
};

// Begins one lineage a visit.
class Founder {
  public:
    // The seed names all chance of this run.
    Founder(Rules rules, base::Seed seed) : rules_(std::move(rules)), seed_(seed) {}

    const Rules& rules() const { return rules_; }
    // Both hold from the next visit on: who has begun goes on as they began.
    void follow(const breeding::WordRanges& ranges, std::vector<genome::Aspect> locked);
    void learn(const School& school);

    Lineage found();
    // The one that was interrupted, by what is taught now or was taught when it may have begun. Nothing, and why is
    // logged, where its deeds do not lead to the same four again.
    std::optional<Lineage> resume(const archive::Generation& kept, const School& school) const;

  private:
    breeding::Breeder breeder_for(base::Seed seed, const std::optional<breeding::WordMap>& map,
                                  const breeding::Taste& taste) const;

    Rules rules_;
    base::Seed seed_;
    std::uint64_t founded_ = 0;
};

}  // namespace quadrat::learning
