// SPDX-License-Identifier: Apache-2.0
#include "nursery/growing.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "machine/low_priority.hpp"
#include "nursery/aspect_store.hpp"
#include "nursery/plot.hpp"

namespace quadrat::nursery {
namespace {

using genome::Aspect;

// Threads that grow are in the background while they do.
class Enrolment : public tbb::task_scheduler_observer {
  public:
    Enrolment(tbb::task_arena& arena, machine::BackgroundThreads& threads)
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
    machine::BackgroundThreads& threads_;
};

#if defined(__SANITIZE_THREAD__)
// Debian's TBB is not instrumented: what its workers hand each other looks like races by the million. One thread at a
// time then; what the frame loop, the grower and the keeper share is checked all the same.
const tbb::global_control kOneWorker(tbb::global_control::max_allowed_parallelism, 1);
#endif

// The four on stage, and as many again for head starts and for going back one step.
constexpr std::size_t kAspectsKept = 2 * genome::kCandidates * genome::kAspects.size();

}  // namespace

std::shared_ptr<const scene::Scene> grow(const genome::Recipe& recipe, const scene::Fineness& fineness) {
    const auto part = [&](Aspect aspect) { return grow_aspect(aspect, recipe.values, recipe.seeds[aspect], fineness); };
    return std::make_shared<const scene::Scene>(
        synthesis::compose(std::get<0>(part(Aspect::Trees)), std::get<1>(part(Aspect::Land)),
                           std::get<2>(part(Aspect::Sky)), planting_of(recipe.seeds), recipe.flight, fineness));
}

struct Grower::Parts {
    explicit Parts(const GrowerOptions& options_)
        : options(options_),
          arena(options_.threads > 0 ? options_.threads : tbb::task_arena::automatic),
          enrolment(arena, threads),
          worker([this](const std::stop_token& stop) { work(stop); }) {}

    struct Job {
        AspectKey key;
        genome::ParameterValues values;
        base::Seed seed;
        std::uint64_t wanted;
    };

    void work(const std::stop_token& stop);
    void grow_batch(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    std::size_t at_once() const { return static_cast<std::size_t>(std::max(1, arena.max_concurrency())); }
    template <typename Work>
    void on_all(std::size_t count, std::unique_lock<std::mutex>& lock, const std::stop_token& stop, const Work& work);
    Plot plot_of(const genome::Candidate& candidate, base::Seed flight) const;
    std::vector<Plot> plots_of(const Order& order) const;
    bool stands(const LayoutKey& key) const;
    void note_standing();
    std::vector<Ahead::Wanted> not_laid_out(std::size_t most) const;
    void lay_out_batch(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    std::vector<Ahead::Wanted> dark(std::size_t most) const;
    void light_batch(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    bool is_ahead_done() const { return not_laid_out(1).empty() && dark(1).empty(); }
    void forget_ahead();
    void take_lit(const Order& wanted);
    void work_out_head_start(std::unique_lock<std::mutex>& lock);
    bool has_work() const;
    void compose_order(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    void finish_order(Scenes made, std::vector<Plot> plots);
    void refine(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    void enqueue(Aspect aspect, std::span<const genome::Candidate> candidates);
    bool has_all(const Order& wanted) const;
    void forget_old();

    GrowerOptions options;
    tbb::task_arena arena;
    machine::BackgroundThreads threads;
    Enrolment enrolment;

    std::mutex mutex;
    std::condition_variable_any changed;
    std::vector<Job> jobs;           // not begun
    std::vector<AspectKey> growing;  // begun
    AspectStore kept;
    std::function<HeadStart()> to_work_out;  // or null
    std::uint64_t head_start_number = 0;
    bool is_working_out = false;
    Ahead ahead;
    std::vector<scene::Ground> standing;  // of what is to be laid out
    std::optional<Order> ordered;         // not composed yet
    Scenes ordered_lit;                   // of those, what was lit ahead, or null
    std::uint64_t order_number = 0;
    std::optional<Scenes> ready;
    std::vector<Plot> to_refine;  // of what is or was ready, in its first light
    bool may_refine = false;
    std::optional<Scenes> refined;
    float progress = 0;

    std::jthread worker;  // last: it uses all of the above
};

void Grower::Parts::enqueue(Aspect aspect, std::span<const genome::Candidate> candidates) {
    kept.pass_time();
    for (const genome::Candidate& candidate : candidates) {
        AspectKey key = key_of(aspect, candidate);
        if (kept.want(key)) continue;
        if (std::ranges::find(jobs, key, &Job::key) == jobs.end() && std::ranges::find(growing, key) == growing.end())
            jobs.push_back({std::move(key), candidate.values, candidate.seeds[aspect], kept.now()});
    }
}

bool Grower::Parts::has_all(const Order& wanted) const {
    for (const genome::Candidate& candidate : wanted.candidates)
        for (const Aspect aspect : genome::kAspects)
            if (!kept.contains(key_of(aspect, candidate))) return false;
    return true;
}

// After every batch: orders that are replaced before they are composed would otherwise pile up what they grew.
void Grower::Parts::forget_old() {
    kept.forget_old(kAspectsKept, [this](const AspectKey& key) {
        return ordered && std::ranges::any_of(ordered->candidates, [&](const genome::Candidate& candidate) {
                   return key == key_of(std::get<0>(key), candidate);
               });
    });
}

void Grower::Parts::grow_batch(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    // One job a core at a time, so that a newer wish need not wait for a long queue of older ones.
    const std::size_t take = std::min(jobs.size(), at_once());
    std::vector<Job> batch(jobs.begin(), jobs.begin() + static_cast<std::ptrdiff_t>(take));
    jobs.erase(jobs.begin(), jobs.begin() + static_cast<std::ptrdiff_t>(take));
    growing.clear();
    for (const Job& job : batch) growing.push_back(job.key);
    lock.unlock();
    std::vector<Grown> grown(batch.size());
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
            if (!stop.stop_requested())
                grown[i] = grow_aspect(std::get<0>(batch[i].key), batch[i].values, batch[i].seed, options.fineness);
        });
    });
    lock.lock();
    growing.clear();
    if (stop.stop_requested()) return;
    for (std::size_t i = 0; i < batch.size(); ++i) kept.keep(batch[i].key, batch[i].wanted, grown[i]);
    forget_old();
    note_standing();
    const float share =
        static_cast<float>(batch.size()) / static_cast<float>(genome::kCandidates * genome::kAspects.size());
    progress = std::min(0.9F, progress + share);
}

bool Grower::Parts::stands(const LayoutKey& key) const {
    return kept.contains(std::get<0>(key)) && kept.contains(std::get<1>(key));
}

void Grower::Parts::note_standing() {
    standing.clear();
    for (const Ahead::Wanted& wanted : ahead.to_lay_out())
        if (const LayoutKey& key = wanted.layout_key(); stands(key))
            standing.push_back({kept.flora(std::get<0>(key)), kept.land(std::get<1>(key))});
}

// It stands.
Plot Grower::Parts::plot_of(const genome::Candidate& candidate, base::Seed flight) const {
    return {planting_of(candidate.seeds),
            flight,
            kept.flora(key_of(Aspect::Trees, candidate)),
            kept.land(key_of(Aspect::Land, candidate)),
            kept.sky(key_of(Aspect::Sky, candidate)),
            ahead.layout(layout_key_of(candidate, flight))};
}

std::vector<Plot> Grower::Parts::plots_of(const Order& order) const {
    std::vector<Plot> plots;
    for (const genome::Candidate& candidate : order.candidates) plots.push_back(plot_of(candidate, order.flight));
    return plots;
}

// Without the lock.
template <typename Work>
void Grower::Parts::on_all(std::size_t count, std::unique_lock<std::mutex>& lock, const std::stop_token& stop,
                           const Work& work) {
    lock.unlock();
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
            if (!stop.stop_requested()) work(i);
        });
    });
    lock.lock();
}

void Grower::Parts::forget_ahead() {
    ahead.forget();
    standing.clear();
}

std::vector<Ahead::Wanted> Grower::Parts::not_laid_out(std::size_t most) const {
    std::vector<Ahead::Wanted> found;
    for (const Ahead::Wanted& wanted : ahead.to_lay_out())
        if (found.size() < most && stands(wanted.layout_key()) && !ahead.layout(wanted.layout_key()))
            found.push_back(wanted);
    return found;
}

void Grower::Parts::lay_out_batch(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const std::vector<Ahead::Wanted> batch = not_laid_out(at_once());
    std::vector<Plot> plots;
    for (const Ahead::Wanted& wanted : batch) plots.push_back(plot_of(wanted.candidate, wanted.flight));
    on_all(plots.size(), lock, stop, [&](std::size_t i) { lay_out(plots[i]); });
    if (stop.stop_requested()) return;
    for (std::size_t i = 0; i < plots.size(); ++i) ahead.keep(batch[i].layout_key(), plots[i].layout);
}

// Laid out, and still without light. Most have no sky either: there are four of each, for four answers.
std::vector<Ahead::Wanted> Grower::Parts::dark(std::size_t most) const {
    std::vector<Ahead::Wanted> found;
    for (const Ahead::Wanted& wanted : ahead.to_light())
        if (found.size() < most && stands(wanted.layout_key()) && ahead.layout(wanted.layout_key()) &&
            !ahead.lit(wanted.key))
            found.push_back(wanted);
    return found;
}

void Grower::Parts::light_batch(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const std::vector<Ahead::Wanted> batch = dark(at_once());
    std::vector<Plot> plots;
    for (const Ahead::Wanted& wanted : batch) plots.push_back(plot_of(wanted.candidate, wanted.flight));
    Scenes made(plots.size());
    const scene::Fineness first = first_light(options.fineness);
    on_all(plots.size(), lock, stop, [&](std::size_t i) {
        const genome::Candidate& candidate = batch[i].candidate;
        if (!plots[i].sky)
            plots[i].sky =
                std::get<2>(grow_aspect(Aspect::Sky, candidate.values, candidate.seeds[Aspect::Sky], options.fineness));
        made[i] = illuminated(plots[i], first);
    });
    if (stop.stop_requested()) return;
    for (std::size_t i = 0; i < batch.size(); ++i) ahead.keep(batch[i].key, made[i]);
}

void Grower::Parts::compose_order(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const std::uint64_t number = order_number;
    std::vector<Plot> plots = plots_of(*ordered);
    Scenes made = ordered_lit;
    const scene::Fineness first = first_light(options.fineness);
    on_all(plots.size(), lock, stop, [&](std::size_t i) {
        if (made[i]) return;
        lay_out(plots[i]);
        made[i] = illuminated(plots[i], first);
    });
    if (stop.stop_requested() || number != order_number) return;
    finish_order(std::move(made), std::move(plots));
}

void Grower::Parts::finish_order(Scenes made, std::vector<Plot> plots) {
    ready = std::move(made);
    if (first_light(options.fineness).light_px < options.fineness.light_px) to_refine = std::move(plots);
    ordered.reset();
    ordered_lit.clear();
    threads.set_awaited(false);
    progress = 1;
}

// The skies of what was lit ahead are kept as if they had been asked for.
void Grower::Parts::take_lit(const Order& wanted) {
    ordered_lit.clear();
    for (const genome::Candidate& candidate : wanted.candidates) {
        ordered_lit.push_back(ahead.lit(scene_key_of(candidate, wanted.flight)));
        if (const auto& lit = ordered_lit.back()) kept.keep(key_of(Aspect::Sky, candidate), kept.now(), lit->sky);
    }
    ahead.want_light({});
}

void Grower::Parts::refine(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const std::uint64_t number = order_number;
    std::vector<Plot> plots = to_refine;
    Scenes made(plots.size());
    on_all(plots.size(), lock, stop, [&](std::size_t i) { made[i] = illuminated(plots[i], options.fineness); });
    if (stop.stop_requested() || number != order_number) return;
    to_refine.clear();
    (ready ? ready : refined) = std::move(made);
}

void Grower::Parts::work_out_head_start(std::unique_lock<std::mutex>& lock) {
    const std::uint64_t number = head_start_number;
    const auto work_out = std::exchange(to_work_out, nullptr);
    is_working_out = true;
    lock.unlock();
    const HeadStart start = work_out();
    lock.lock();
    is_working_out = false;
    if (number != head_start_number) return;
    for (const Aspect aspect : start.known) enqueue(aspect, start.coming.candidates);
    const auto is_known = [&](Aspect aspect) { return std::ranges::find(start.known, aspect) != start.known.end(); };
    if (is_known(Aspect::Trees) && is_known(Aspect::Land)) ahead.want_layouts(start.coming);
    ahead.want_light(start.possible);
    note_standing();
}

bool Grower::Parts::has_work() const {
    return ordered || (may_refine && !to_refine.empty()) || to_work_out || !jobs.empty() || !is_ahead_done();
}

void Grower::Parts::work(const std::stop_token& stop) {
    threads.enter();
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
        if (ordered && has_all(*ordered)) {
            compose_order(lock, stop);
        } else if (to_work_out) {
            work_out_head_start(lock);
        } else if (may_refine && !to_refine.empty()) {
            refine(lock, stop);
        } else if (!jobs.empty()) {
            grow_batch(lock, stop);
        } else if (!not_laid_out(1).empty()) {
            lay_out_batch(lock, stop);
        } else if (!dark(1).empty()) {
            light_batch(lock, stop);
        } else {
            changed.wait(lock, stop, [this] { return has_work(); });
        }
        changed.notify_all();
    }
}

Grower::Grower(const GrowerOptions& options) : parts_(std::make_unique<Parts>(options)) {}

Grower::~Grower() {
    parts_->worker.request_stop();
    parts_->changed.notify_all();
}

void Grower::begin(std::function<HeadStart()> work_out) {
    const std::scoped_lock lock(parts_->mutex);
    parts_->to_work_out = std::move(work_out);
    ++parts_->head_start_number;
    parts_->changed.notify_all();
}

Prospect Grower::ahead() {
    const std::scoped_lock lock(parts_->mutex);
    Scenes lit = parts_->ordered ? parts_->ordered_lit : parts_->ahead.lit();
    std::erase(lit, nullptr);
    return {parts_->standing, std::move(lit)};
}

void Grower::order(Order wanted) {
    const std::scoped_lock lock(parts_->mutex);
    parts_->to_work_out = nullptr;  // head starts for answers that were not given
    ++parts_->head_start_number;
    parts_->jobs.clear();
    parts_->take_lit(wanted);
    for (const Aspect aspect : genome::kAspects) parts_->enqueue(aspect, wanted.candidates);
    ++parts_->order_number;
    parts_->ready.reset();
    parts_->may_refine = false;
    parts_->to_refine.clear();
    parts_->refined.reset();
    parts_->progress = 0;
    parts_->ordered = std::move(wanted);
    parts_->forget_old();
    const bool is_lit = std::ranges::find(parts_->ordered_lit, nullptr) == parts_->ordered_lit.end();
    if (is_lit && parts_->has_all(*parts_->ordered))
        parts_->finish_order(parts_->ordered_lit, parts_->plots_of(*parts_->ordered));
    parts_->threads.set_awaited(parts_->ordered.has_value());
    parts_->changed.notify_all();
}

bool Grower::is_ready() {
    const std::scoped_lock lock(parts_->mutex);
    return parts_->ready.has_value();
}

std::optional<Scenes> Grower::take() {
    const std::scoped_lock lock(parts_->mutex);
    if (parts_->ready && parts_->to_refine.empty()) parts_->forget_ahead();
    return std::exchange(parts_->ready, std::nullopt);
}

void Grower::refine() {
    const std::scoped_lock lock(parts_->mutex);
    if (std::exchange(parts_->may_refine, true)) return;
    parts_->changed.notify_all();
}

std::optional<Scenes> Grower::take_refined() {
    const std::scoped_lock lock(parts_->mutex);
    if (parts_->refined) parts_->forget_ahead();
    return std::exchange(parts_->refined, std::nullopt);
}

bool Grower::is_refining() {
    const std::scoped_lock lock(parts_->mutex);
    return !parts_->to_refine.empty() || parts_->refined;
}

float Grower::progress() {
    const std::scoped_lock lock(parts_->mutex);
    return parts_->progress;
}

Grower::Stock Grower::stock() {
    const std::scoped_lock lock(parts_->mutex);
    const std::size_t to_grow = parts_->jobs.size() + parts_->growing.size();
    return {parts_->kept.size(), to_grow, parts_->is_working_out || to_grow > 0 || parts_->has_work()};
}

void Grower::wait() {
    refine();
    std::unique_lock lock(parts_->mutex);
    parts_->changed.wait(lock, [this] { return !parts_->ordered && parts_->to_refine.empty(); });
}

}  // namespace quadrat::nursery
