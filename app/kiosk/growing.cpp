// SPDX-License-Identifier: Apache-2.0
#include "kiosk/growing.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "kiosk/low_priority.hpp"
#include "kiosk/plot.hpp"

namespace quadrat::kiosk {
namespace {

using genome::Aspect;

// Threads that grow give way to the one that draws.
class LowPriority : public tbb::task_scheduler_observer {
  public:
    explicit LowPriority(tbb::task_arena& arena) : tbb::task_scheduler_observer(arena) { observe(true); }
    ~LowPriority() override { observe(false); }
    LowPriority(const LowPriority&) = delete;
    LowPriority& operator=(const LowPriority&) = delete;
    void on_scheduler_entry(bool /*is_worker*/) override { lower_priority(); }
};

struct Order {
    std::vector<genome::Candidate> candidates;
    base::Seed flight;
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
    Plot plot{planting_of(recipe.seeds), recipe.flight, std::get<0>(part(Aspect::Trees)),
              std::get<1>(part(Aspect::Land)), std::get<2>(part(Aspect::Sky))};
    lay_out(plot);
    return illuminated(plot, fineness);
}

struct Grower::Parts {
    explicit Parts(const GrowerOptions& options_)
        : options(options_),
          arena(options_.threads > 0 ? options_.threads : tbb::task_arena::automatic),
          observer(arena),
          worker([this](const std::stop_token& stop) { work(stop); }) {}

    struct Kept {
        std::uint64_t wanted;  // when, last
        Grown grown;
    };
    struct Job {
        AspectKey key;
        genome::ParameterValues values;
        base::Seed seed;
        std::uint64_t wanted;
    };

    void work(const std::stop_token& stop);
    void grow_batch(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    bool can_be_laid_out(const genome::Candidate& candidate) const;
    bool can_lay_out() const;
    void note_standing();
    void forget_ahead();
    void lay_out_batch(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    Plot plot_of(const genome::Candidate& candidate, base::Seed flight) const;
    template <typename Work>
    void on_all(std::vector<Plot>& plots, std::unique_lock<std::mutex>& lock, const std::stop_token& stop,
                const Work& work);
    void compose_order(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    void refine(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    void enqueue(Aspect aspect, std::span<const genome::Candidate> candidates);
    bool has_all(const Order& wanted) const;
    bool is_ordered(const AspectKey& key) const;
    void forget_old();

    GrowerOptions options;
    tbb::task_arena arena;
    LowPriority observer;

    std::mutex mutex;
    std::condition_variable_any changed;
    std::vector<Job> jobs;           // not begun
    std::vector<AspectKey> growing;  // begun
    std::map<AspectKey, Kept> kept;
    std::optional<Order> ahead;                                             // the last that were to be laid out
    std::map<LayoutKey, std::shared_ptr<const synthesis::Layout>> layouts;  // of those
    std::vector<render::Ground> standing;                                   // of those
    std::uint64_t wants = 0;
    std::optional<Order> ordered;  // not composed yet
    std::uint64_t order_number = 0;
    std::optional<Scenes> ready;
    std::vector<Plot> to_refine;  // of what is or was ready, in its first light
    std::optional<Scenes> refined;
    float progress = 0;

    std::jthread worker;  // last: it uses all of the above
};

void Grower::Parts::enqueue(Aspect aspect, std::span<const genome::Candidate> candidates) {
    ++wants;
    for (const genome::Candidate& candidate : candidates) {
        AspectKey key = key_of(aspect, candidate);
        if (const auto found = kept.find(key); found != kept.end()) {
            found->second.wanted = wants;
            continue;
        }
        if (std::ranges::find(jobs, key, &Job::key) == jobs.end() && std::ranges::find(growing, key) == growing.end())
            jobs.push_back({std::move(key), candidate.values, candidate.seeds[aspect], wants});
    }
}

bool Grower::Parts::has_all(const Order& wanted) const {
    for (const genome::Candidate& candidate : wanted.candidates)
        for (const Aspect aspect : genome::kAspects)
            if (!kept.contains(key_of(aspect, candidate))) return false;
    return true;
}

bool Grower::Parts::is_ordered(const AspectKey& key) const {
    if (!ordered) return false;
    return std::ranges::any_of(ordered->candidates, [&](const genome::Candidate& candidate) {
        return key == key_of(std::get<0>(key), candidate);
    });
}

// After every batch: orders that are replaced before they are composed would otherwise pile up what they grew.
void Grower::Parts::forget_old() {
    while (kept.size() > kAspectsKept) {
        auto oldest = kept.end();
        for (auto i = kept.begin(); i != kept.end(); ++i) {
            if (is_ordered(i->first)) continue;
            if (oldest == kept.end() || i->second.wanted < oldest->second.wanted) oldest = i;
        }
        if (oldest == kept.end()) return;
        kept.erase(oldest);
    }
}

void Grower::Parts::grow_batch(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    // One job a core at a time, so that a newer wish need not wait for a long queue of older ones.
    const auto take = std::min(jobs.size(), static_cast<std::size_t>(std::max(1, arena.max_concurrency())));
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
    for (std::size_t i = 0; i < batch.size(); ++i) kept[batch[i].key] = {batch[i].wanted, grown[i]};
    forget_old();
    note_standing();
    const float share =
        static_cast<float>(batch.size()) / static_cast<float>(genome::kCandidates * genome::kAspects.size());
    progress = std::min(0.9F, progress + share);
}

void Grower::Parts::note_standing() {
    standing.clear();
    if (!ahead) return;
    for (const genome::Candidate& candidate : ahead->candidates) {
        const auto trees = kept.find(key_of(Aspect::Trees, candidate));
        const auto land = kept.find(key_of(Aspect::Land, candidate));
        if (trees != kept.end() && land != kept.end())
            standing.push_back({std::get<0>(trees->second.grown), std::get<1>(land->second.grown)});
    }
}

void Grower::Parts::forget_ahead() {
    ahead.reset();
    layouts.clear();
    standing.clear();
}

bool Grower::Parts::can_be_laid_out(const genome::Candidate& candidate) const {
    return kept.contains(key_of(Aspect::Trees, candidate)) && kept.contains(key_of(Aspect::Land, candidate)) &&
           !layouts.contains(layout_key_of(candidate, ahead->flight));
}

bool Grower::Parts::can_lay_out() const {
    return ahead && std::ranges::any_of(ahead->candidates, [this](const auto& c) { return can_be_laid_out(c); });
}

Plot Grower::Parts::plot_of(const genome::Candidate& candidate, base::Seed flight) const {
    const auto sky = kept.find(key_of(Aspect::Sky, candidate));
    const auto layout = layouts.find(layout_key_of(candidate, flight));
    return {planting_of(candidate.seeds),
            flight,
            std::get<0>(kept.at(key_of(Aspect::Trees, candidate)).grown),
            std::get<1>(kept.at(key_of(Aspect::Land, candidate)).grown),
            sky == kept.end() ? nullptr : std::get<2>(sky->second.grown),
            layout == layouts.end() ? nullptr : layout->second};
}

// Without the lock.
template <typename Work>
void Grower::Parts::on_all(std::vector<Plot>& plots, std::unique_lock<std::mutex>& lock, const std::stop_token& stop,
                           const Work& work) {
    lock.unlock();
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, plots.size(), [&](std::size_t i) {
            if (!stop.stop_requested()) work(i);
        });
    });
    lock.lock();
}

void Grower::Parts::lay_out_batch(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const base::Seed flight = ahead->flight;
    std::vector<LayoutKey> keys;
    std::vector<Plot> plots;
    const auto most = static_cast<std::size_t>(std::max(1, arena.max_concurrency()));
    for (const genome::Candidate& candidate : ahead->candidates) {
        if (plots.size() == most || !can_be_laid_out(candidate)) continue;
        keys.push_back(layout_key_of(candidate, flight));
        plots.push_back(plot_of(candidate, flight));
    }
    on_all(plots, lock, stop, [&](std::size_t i) { lay_out(plots[i]); });
    if (stop.stop_requested()) return;
    for (std::size_t i = 0; i < plots.size(); ++i) layouts[keys[i]] = plots[i].layout;
}

void Grower::Parts::compose_order(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const std::uint64_t number = order_number;
    std::vector<Plot> plots;
    for (const genome::Candidate& candidate : ordered->candidates) plots.push_back(plot_of(candidate, ordered->flight));
    const scene::Fineness first = first_light(options.fineness);
    Scenes made(plots.size());
    on_all(plots, lock, stop, [&](std::size_t i) {
        lay_out(plots[i]);
        made[i] = illuminated(plots[i], first);
    });
    if (stop.stop_requested() || number != order_number) return;
    ready = std::move(made);
    if (first.light_px < options.fineness.light_px) to_refine = std::move(plots);
    ordered.reset();
    progress = 1;
}

void Grower::Parts::refine(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const std::uint64_t number = order_number;
    std::vector<Plot> plots = to_refine;
    Scenes made(plots.size());
    on_all(plots, lock, stop, [&](std::size_t i) { made[i] = illuminated(plots[i], options.fineness); });
    if (stop.stop_requested() || number != order_number) return;
    to_refine.clear();
    (ready ? ready : refined) = std::move(made);
}

void Grower::Parts::work(const std::stop_token& stop) {
    lower_priority();
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
        if (ordered && has_all(*ordered)) {
            compose_order(lock, stop);
        } else if (!to_refine.empty()) {
            refine(lock, stop);
        } else if (!jobs.empty()) {
            grow_batch(lock, stop);
        } else if (can_lay_out()) {
            lay_out_batch(lock, stop);
        } else {
            changed.wait(lock, stop, [this] { return !jobs.empty() || ordered || can_lay_out(); });
        }
        changed.notify_all();
    }
}

Grower::Grower(const GrowerOptions& options) : parts_(std::make_unique<Parts>(options)) {}

Grower::~Grower() {
    parts_->worker.request_stop();
    parts_->changed.notify_all();
}

void Grower::begin(Aspect aspect, const genome::Offer& offer) {
    const std::scoped_lock lock(parts_->mutex);
    parts_->enqueue(aspect, offer.candidates);
    parts_->changed.notify_all();
}

void Grower::begin_layouts(const genome::Offer& offer, base::Seed flight) {
    const std::scoped_lock lock(parts_->mutex);
    parts_->ahead = Order{{offer.candidates.begin(), offer.candidates.end()}, flight};
    std::erase_if(parts_->layouts, [&](const auto& layout) {
        return std::ranges::none_of(offer.candidates, [&](const genome::Candidate& candidate) {
            return layout.first == layout_key_of(candidate, flight);
        });
    });
    parts_->note_standing();
    parts_->changed.notify_all();
}

std::vector<render::Ground> Grower::ahead() {
    const std::scoped_lock lock(parts_->mutex);
    return parts_->standing;
}

void Grower::order(std::vector<genome::Candidate> candidates, base::Seed flight) {
    const std::scoped_lock lock(parts_->mutex);
    parts_->jobs.clear();  // head starts for answers that were not given
    for (const Aspect aspect : genome::kAspects) parts_->enqueue(aspect, candidates);
    parts_->ordered = Order{std::move(candidates), flight};
    ++parts_->order_number;
    parts_->ready.reset();
    parts_->to_refine.clear();
    parts_->refined.reset();
    parts_->progress = 0;
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
    return {parts_->kept.size(), to_grow, to_grow > 0 || parts_->ordered || !parts_->to_refine.empty()};
}

void Grower::wait() {
    std::unique_lock lock(parts_->mutex);
    parts_->changed.wait(lock, [this] { return !parts_->ordered && parts_->to_refine.empty(); });
}

}  // namespace quadrat::kiosk
