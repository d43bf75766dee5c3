// SPDX-License-Identifier: Apache-2.0
#include "nursery/growing.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <utility>

#include "base/worker.hpp"
#include "nursery/enrolment.hpp"

namespace quadrat::nursery {
namespace {

using genome::Aspect;

#if defined(__SANITIZE_THREAD__)
// Debian's TBB is not instrumented: what its workers hand each other looks like races by the million. One thread at a
// time then; what the frame loop, the nursery and the keeper share is checked all the same.
const tbb::global_control kOneWorker(tbb::global_control::max_allowed_parallelism, 1);
#endif

}  // namespace

std::shared_ptr<const scene::Scene> grow(const genome::Recipe& recipe, const scene::Fineness& fineness) {
    const auto part = [&](Aspect aspect) { return grow_aspect(aspect, recipe.values, recipe.seeds[aspect], fineness); };
    return std::make_shared<const scene::Scene>(
        synthesis::compose(std::get<0>(part(Aspect::Trees)), std::get<1>(part(Aspect::Land)),
                           std::get<2>(part(Aspect::Sky)), planting_of(recipe.seeds), recipe.flight, fineness));
}

struct Nursery::Parts {
    explicit Parts(const NurseryOptions& options)
        : fineness(options.fineness),
          arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic),
          enrolment(arena, threads),
          graph(options.fineness) {}

    std::size_t at_once() const { return static_cast<std::size_t>(std::max(1, arena.max_concurrency())); }
    bool has_work() const { return is_stepping || to_work_out || !graph.next(1).empty(); }
    void go_on();
    void take_a_step(std::unique_lock<std::mutex>& lock);
    void work_out(std::unique_lock<std::mutex>& lock);
    void carry_out_all(std::vector<Job> jobs, std::unique_lock<std::mutex>& lock);
    void set_awaited();

    scene::Fineness fineness;
    tbb::task_arena arena;
    base::BackgroundThreads threads;
    Enrolment enrolment;

    std::mutex mutex;  // of what follows; held for moments
    std::condition_variable changed;
    Graph graph;
    std::function<std::vector<Want>()> to_work_out;  // or null
    std::uint64_t foreseen = 0;                      // how often
    bool is_stepping = false;                        // or soon will
    std::stop_source ending;
    base::Worker worker{{.name = "nursery",
                         .bound = 2,
                         .at_end = base::WorkerOptions::AtEnd::Drop,
                         .priority = base::WorkerOptions::Priority::Background}};  // last: it uses all of the above
};

void Nursery::Parts::set_awaited() {
    threads.set_awaited(graph.has_unfinished_awaited());
    worker.set_awaited(graph.has_unfinished_awaited());
}

// With the lock: one step after another, as long as there is work.
void Nursery::Parts::go_on() {
    if (is_stepping || ending.stop_requested() || !has_work()) return;
    is_stepping = worker.send([this] {
        std::unique_lock lock(mutex);
        take_a_step(lock);
        is_stepping = false;
        set_awaited();
        go_on();
        changed.notify_all();
    });
}

void Nursery::Parts::take_a_step(std::unique_lock<std::mutex>& lock) {
    std::vector<Job> jobs = graph.next(at_once(), Urgency::Awaited);
    if (jobs.empty() && to_work_out) return work_out(lock);
    if (jobs.empty()) jobs = graph.next(at_once());
    carry_out_all(std::move(jobs), lock);
}

void Nursery::Parts::work_out(std::unique_lock<std::mutex>& lock) {
    const std::uint64_t number = foreseen;
    const auto work = std::exchange(to_work_out, nullptr);
    lock.unlock();
    std::vector<Want> wants = work();
    lock.lock();
    if (number == foreseen) graph.foresee(std::move(wants));
}

void Nursery::Parts::carry_out_all(std::vector<Job> jobs, std::unique_lock<std::mutex>& lock) {
    lock.unlock();
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
            if (!ending.stop_requested()) carry_out(jobs[i], fineness);
        });
    });
    lock.lock();
    if (!ending.stop_requested()) graph.take(std::move(jobs));
}

Nursery::Nursery(const NurseryOptions& options) : parts_(std::make_unique<Parts>(options)) {}

Nursery::~Nursery() { parts_->ending.request_stop(); }

void Nursery::want(std::vector<Want> wants) {
    const bool is_order = std::ranges::any_of(wants, is_most_urgent);
    const std::scoped_lock lock(parts_->mutex);
    parts_->graph.want(std::move(wants));
    if (is_order) {
        parts_->to_work_out = nullptr;  // for answers that were not given
        ++parts_->foreseen;
    }
    parts_->set_awaited();
    parts_->go_on();
}

void Nursery::foresee(std::function<std::vector<Want>()> work_out) {
    const std::scoped_lock lock(parts_->mutex);
    parts_->to_work_out = std::move(work_out);
    ++parts_->foreseen;
    parts_->go_on();
}

std::optional<Graph::AllLit> Nursery::find(const Landscapes& landscapes) const {
    const std::scoped_lock lock(parts_->mutex);
    return parts_->graph.find(landscapes);
}

Prospect Nursery::ahead() const {
    const std::scoped_lock lock(parts_->mutex);
    return parts_->graph.ahead();
}

float Nursery::progress() const {
    const std::scoped_lock lock(parts_->mutex);
    return parts_->graph.progress();
}

Nursery::Stock Nursery::stock() const {
    const std::scoped_lock lock(parts_->mutex);
    return {parts_->graph.kept(), parts_->graph.to_grow(), parts_->has_work()};
}

void Nursery::wait() {
    std::unique_lock lock(parts_->mutex);
    parts_->graph.hurry();
    parts_->go_on();
    parts_->changed.wait(lock, [this] { return parts_->graph.is_there(); });
}

}  // namespace quadrat::nursery
