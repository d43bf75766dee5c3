// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

#include "base/background_threads.hpp"

namespace quadrat::nursery {

// Threads that grow are in the background while they do.
class Enrolment : public tbb::task_scheduler_observer {
  public:
    Enrolment(tbb::task_arena& arena, base::BackgroundThreads& threads)
        : tbb::task_scheduler_observer(arena), threads_(threads) {
        observe(true);
    }
    ~Enrolment() override { observe(false); }
    Enrolment(const Enrolment&) = delete;
    Enrolment& operator=(const Enrolment&) = delete;
    void on_scheduler_entry(bool is_worker) override {
        if (is_worker) threads_.enter();
    }
    void on_scheduler_exit(bool is_worker) override {
        if (is_worker) threads_.leave();
    }

  private:
    base::BackgroundThreads& threads_;
};

}  // namespace quadrat::nursery
