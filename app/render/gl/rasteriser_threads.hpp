// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sched.h>
#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace quadrat::render::gl {

// A software rasteriser's threads, as many as there are cores, which they share with the thread that feeds them. They
// begin and end every batch of work together: where one is queued behind the feeder, the others wait for it, and cores
// stand still.
class RasteriserThreads {
  public:
    RasteriserThreads() = default;  // none, as where a GPU draws: nothing is ever moved
    // Those of this process whose names begin so: "llvmpipe-".
    static RasteriserThreads of_this_process(std::string_view name_begins);

    std::size_t count() const { return threads_.size(); }

    // While this lives they keep off the calling thread's core, on which it stays; then one of them has that core, and
    // all may go where they might before.
    class Feeding {
      public:
        explicit Feeding(const RasteriserThreads& threads);
        ~Feeding();
        Feeding(const Feeding&) = delete;
        Feeding& operator=(const Feeding&) = delete;

      private:
        const RasteriserThreads& threads_;
        std::optional<int> core_;  // none: there is no other
        cpu_set_t feeder_before_{};
    };

  private:
    struct Thread {
        pid_t id;
        cpu_set_t cores;
    };
    std::vector<Thread> threads_;
};

}  // namespace quadrat::render::gl
