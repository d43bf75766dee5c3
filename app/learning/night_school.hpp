// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>

#include "learning/keeper.hpp"
#include "learning/school.hpp"

namespace quadrat::learning {

// When the site's school is held: at the start and every night, with what visitors have said since.
class NightSchool {
  public:
    // local_time: the site's own, which says when it is night.
    NightSchool(const std::filesystem::path& folder, School::OfTaste of_taste,
                std::function<archive::WallTime()> local_time)
        : local_time_(std::move(local_time)), school_(std::make_shared<School>(folder, of_taste)) {}

    // Beside the first visit, which has the map of before.
    void begin(Keeper& keeper);
    // True: map or taste is another now. Begins anew where another night has come and nobody is there.
    bool look(Keeper& keeper, bool is_anybody_there);
    void wait(Keeper& keeper);  // until what was begun is learnt

    const School& school() const { return *school_; }

  private:
    std::function<archive::WallTime()> local_time_;
    std::shared_ptr<School> school_;  // the keeper's thread begins its lessons
    std::int64_t night_ = 0;          // of the last of them
    Keeper::Ticket asked_ = 0;        // for what visitors said
};

}  // namespace quadrat::learning
