// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/types.h>

#include <mutex>
#include <vector>

namespace quadrat::base {

// Threads that work for what may be asked next: they run when nobody else would, so that a thread that draws never
// waits until one of them has used its slice of time. While somebody waits for what they make, they take a share of
// the cores, a small one (nice 10). Where the system would not let them come back to that (RLIMIT_NICE), they
// never leave it. Any thread may call any of it.
class BackgroundThreads {
  public:
    void enter();  // the calling thread, from now on
    void leave();  // it ends, or does other work
    void set_awaited(bool is_awaited);

    // The calling thread, as long as this lives.
    class Stay {
      public:
        explicit Stay(BackgroundThreads& threads) : threads_(threads) { threads.enter(); }
        ~Stay() { threads_.leave(); }
        Stay(const Stay&) = delete;
        Stay& operator=(const Stay&) = delete;

      private:
        BackgroundThreads& threads_;
    };

  private:
    void apply(pid_t thread) const;

    std::mutex mutex_;
    std::vector<pid_t> threads_;
    bool is_awaited_ = false;
};

}  // namespace quadrat::base
