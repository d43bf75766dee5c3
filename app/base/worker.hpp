// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "base/background_threads.hpp"

namespace quadrat::base {

struct WorkerOptions {
    enum class Priority {
        Usual,
        Background  // see BackgroundThreads; somebody may come to wait for it
    };
    // What becomes of a task for which there is no room.
    enum class WhenFull {
        Refuse,      // it is not taken
        DropOldest,  // it takes the place of the oldest that has not begun
        Wait         // its sender waits
    };
    // What becomes of tasks that have not begun when the worker ends.
    enum class AtEnd { Finish, Drop };

    const char* name;       // of its threads, as debuggers and top(1) show it: 15 letters at most
    std::size_t bound = 1;  // on tasks that were sent and are not finished, 1 at least
    WhenFull when_full = WhenFull::Refuse;
    AtEnd at_end = AtEnd::Finish;
    Priority priority = Priority::Usual;
    std::size_t threads = 1;  // at most; each begins when it is needed
};

// Work that a worker has begun, or will. Its owner waits for its end at the latest when this goes.
template <typename Result>
class Begun {
  public:
    Begun() = default;  // of nothing
    Begun(std::future<Result> result, std::future<void> end) : result_(std::move(result)), end_(std::move(end)) {}
    Begun(Begun&&) noexcept = default;
    Begun& operator=(Begun&& other) noexcept {
        wait();
        result_ = std::move(other.result_);
        end_ = std::move(other.end_);
        return *this;
    }
    ~Begun() { wait(); }

    bool is_something() const { return result_.valid(); }  // false too where it was not taken, and once it was got
    // Once it is, its worker has room for another.
    bool is_over() const { return !end_.valid() || end_.wait_for(std::chrono::seconds{0}) == kReady; }
    void wait() const {
        if (end_.valid()) end_.wait();
    }
    // Of something, once: waits, and throws what the work threw, or std::future_error where it was dropped.
    Result get() {
        wait();
        return result_.get();
    }

  private:
    static constexpr std::future_status kReady = std::future_status::ready;
    std::future<Result> result_;
    std::future<void> end_;
};

// Does what must not keep its sender waiting, on threads of its own. Tasks begin in the order in which they were sent;
// with one thread each ends before the next begins. Any thread may call any of it, but for the destructor.
class Worker {
  public:
    using Task = std::function<void()>;  // must not throw

    explicit Worker(const WorkerOptions& options) : options_(options) {}
    ~Worker();  // waits for what has begun, and for the rest as the options say
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    // False: it was not taken.
    bool send(Task task) { return send_at({}, std::move(task)); }
    // Begins at that time, or later, behind what was sent for earlier; at once where the worker ends and finishes.
    bool send_at(std::chrono::steady_clock::time_point due, Task task) { return take(due, {std::move(task), {}}); }

    // The same for work that has a result, may throw, or uses what its owner has.
    template <typename Work>
    auto begin(Work work) {
        using Result = std::invoke_result_t<Work>;
        const auto task = std::make_shared<std::packaged_task<Result()>>(std::move(work));
        const auto end = std::make_shared<std::promise<void>>();
        std::future<Result> result = task->get_future();
        if (!take({}, {[task] { (*task)(); }, [end] { end->set_value(); }})) return Begun<Result>{};
        return Begun<Result>{std::move(result), end->get_future()};
    }

    void drop_waiting();  // what has not begun
    void finish();        // waits until all that was sent is finished
    // Whether somebody waits for what is done here; of the background's threads alone.
    void set_awaited(bool is_awaited) { background_.set_awaited(is_awaited); }

  private:
    using Due = std::chrono::steady_clock::time_point;
    struct Sent {
        Task task;
        Task tell_end;  // once there is room for another; or null
    };
    bool take(Due due, Sent sent);
    bool make_room(std::unique_lock<std::mutex>& lock);
    bool wait_for_task(std::unique_lock<std::mutex>& lock);
    void work();

    const WorkerOptions options_;
    BackgroundThreads background_;
    std::mutex mutex_;  // of what follows; held for moments
    std::condition_variable changed_;
    std::multimap<Due, Sent> waiting_;
    std::size_t unfinished_ = 0;  // waiting or begun
    bool is_ending_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace quadrat::base
