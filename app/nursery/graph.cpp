// SPDX-License-Identifier: Apache-2.0
#include "nursery/graph.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::nursery {
namespace {

using genome::Aspect;

bool is_in(const std::vector<Want>& wants, const LayoutKey& key) {
    return std::ranges::any_of(wants, [&](const Want& w) { return w.landscape->layout_key() == key; });
}

// Aspects that are grown by themselves. Of what is coming there is a sky for each answer that can be given: it grows
// with its light, and is a part of the scene alone.
bool grows_alone(const Want& want, Aspect aspect) {
    const bool comes_with_its_light =
        want.urgency == Urgency::Coming && want.stage >= Stage::FirstLight && aspect == Aspect::Sky;
    return want.known[aspect] && !comes_with_its_light;
}

bool is_same_aspect(const Job& job, Aspect aspect, const Landscape& landscape) {
    return job.aspect == aspect && job.landscape->aspect_key(aspect) == landscape.aspect_key(aspect);
}

}  // namespace

const AspectKey& Landscape::aspect_key(Aspect aspect) const {
    if (aspect == Aspect::Sky) return std::get<1>(key);
    return aspect == Aspect::Trees ? std::get<0>(layout_key()) : std::get<1>(layout_key());
}

std::shared_ptr<const Landscape> landscape_of(genome::Candidate candidate, base::Seed flight) {
    SceneKey key = scene_key_of(candidate, flight);
    return std::make_shared<const Landscape>(Landscape{std::move(candidate), flight, std::move(key)});
}

Landscapes landscapes_of(const std::vector<genome::Candidate>& candidates, base::Seed flight) {
    Landscapes all;
    for (const genome::Candidate& candidate : candidates) all.push_back(landscape_of(candidate, flight));
    return all;
}

std::vector<Want> wants_for(const Landscapes& landscapes, Stage stage, Urgency urgency) {
    std::vector<Want> wants;
    for (const auto& landscape : landscapes) wants.push_back({landscape, stage, urgency});
    return wants;
}

void carry_out(Job& job, const scene::Fineness& fineness) {
    const genome::Candidate& candidate = job.landscape->candidate;
    const auto grown = [&](Aspect aspect) {
        return grow_aspect(aspect, candidate.values, candidate.seeds[aspect], fineness);
    };
    if (job.stage == Stage::Aspects) {
        job.grown = grown(job.aspect);
        return;
    }
    lay_out(job.plot);
    if (job.stage == Stage::Layout) return;
    if (!job.plot.sky) job.plot.sky = std::get<2>(grown(Aspect::Sky));
    job.lit = illuminated(job.plot, job.stage == Stage::FirstLight ? first_light(fineness) : fineness);
}

void Graph::want(std::vector<Want> wants) {
    wants_ = std::move(wants);
    const bool is_order = std::ranges::any_of(wants_, is_most_urgent);
    for (Foreseen& one : foreseen_)
        if (is_order) one.was_ordered = is_in(wants_, one.want.landscape->layout_key());
    std::erase_if(foreseen_, [&](const Foreseen& one) {
        if (is_order) return !one.was_ordered;
        return one.was_ordered && !is_in(wants_, one.want.landscape->layout_key());
    });
    for (const Want& want : wants_)
        if (const Lit lit = find(*want.landscape); lit.scene && is_most_urgent(want))
            aspects_.keep(want.landscape->aspect_key(Aspect::Sky), aspects_.now(), lit.scene->sky);
    remember_aspects(wants_);
    forget();
}

void Graph::foresee(std::vector<Want> wants) {
    foreseen_.clear();
    remember_aspects(wants);
    for (Want& want : wants) {
        const bool is_twice = std::ranges::any_of(foreseen_, [&](const Foreseen& one) {
            return one.want.stage == want.stage && one.want.landscape->key == want.landscape->key;
        });
        if (is_twice) continue;
        want.urgency = Urgency::Coming;
        foreseen_.push_back({std::move(want)});
    }
    forget();
}

void Graph::hurry() {
    for (Want& want : wants_)
        if (is_most_urgent(want)) want.stage = Stage::FullLight;
}

bool Graph::has(const Want& want) const {
    const Landscape& landscape = *want.landscape;
    const Lit lit = find(landscape);
    if (want.stage == Stage::FullLight) return lit.is_full;
    if (lit.scene) return true;
    if (want.stage == Stage::FirstLight) return false;
    if (want.stage == Stage::Layout) return layouts_.contains(landscape.layout_key());
    return std::ranges::all_of(genome::kAspects, [&](Aspect aspect) {
        return !grows_alone(want, aspect) || aspects_.contains(landscape.aspect_key(aspect));
    });
}

bool Graph::stands(const Landscape& landscape) const {
    return aspects_.contains(landscape.aspect_key(Aspect::Trees)) &&
           aspects_.contains(landscape.aspect_key(Aspect::Land));
}

Plot Graph::plot_of(const Landscape& landscape) const {
    const auto layout = layouts_.find(landscape.layout_key());
    Plot plot{planting_of(landscape.candidate.seeds), landscape.flight,
              aspects_.flora(landscape.aspect_key(Aspect::Trees)), aspects_.land(landscape.aspect_key(Aspect::Land)),
              aspects_.sky(landscape.aspect_key(Aspect::Sky))};
    if (layout != layouts_.end()) plot.layout = layout->second;
    if (const Lit lit = find(landscape); lit.scene) {
        plot.flora = lit.scene->flora;
        plot.land = lit.scene->land;
        plot.sky = lit.scene->sky;
    }
    return plot;
}

// Those of its aspects that are still to grow, each once.
void Graph::add_missing_aspects(const Want& want, Aspect aspect, std::vector<Job>& jobs) const {
    const Landscape& landscape = *want.landscape;
    if (!grows_alone(want, aspect) || has(want) || find(landscape).scene) return;
    if (aspects_.contains(landscape.aspect_key(aspect))) return;
    if (std::ranges::none_of(jobs, [&](const Job& job) { return is_same_aspect(job, aspect, landscape); }))
        jobs.push_back({want.landscape, Stage::Aspects, aspect});
}

std::vector<Job> Graph::missing_aspects(Urgency urgency) const {
    std::vector<Job> jobs;
    for (const Aspect aspect : genome::kAspects) {
        for (const Want& want : wants_)
            if (want.urgency == urgency) add_missing_aspects(want, aspect, jobs);
        for (const Foreseen& one : foreseen_)
            if (urgency == Urgency::Coming && !one.was_ordered) add_missing_aspects(one.want, aspect, jobs);
    }
    return jobs;
}

std::vector<Job> Graph::missing_light(Urgency urgency) const {
    std::vector<Job> first, full;
    for (const Want& want : wants_) {
        if (want.urgency != urgency || has(want)) continue;
        const bool is_dark = find(*want.landscape).scene == nullptr && urgency != Urgency::Spare;
        std::vector<Job>& jobs = is_dark ? first : full;
        if (std::ranges::any_of(jobs, [&](const Job& j) { return j.landscape->key == want.landscape->key; })) continue;
        jobs.push_back({want.landscape, is_dark ? Stage::FirstLight : Stage::FullLight, {}, plot_of(*want.landscape)});
    }
    return first.empty() ? full : first;
}

// Layouts before light: for each there are the skies of four answers.
std::vector<Job> Graph::missing_ahead() const {
    std::vector<Job> layouts, light;
    for (const Foreseen& one : foreseen_) {
        const Landscape& landscape = *one.want.landscape;
        if (one.was_ordered || one.want.stage == Stage::Aspects || !stands(landscape) || find(landscape).scene)
            continue;
        if (layouts_.contains(landscape.layout_key())) {
            if (one.want.stage >= Stage::FirstLight)
                light.push_back({one.want.landscape, Stage::FirstLight, {}, plot_of(landscape)});
        } else if (std::ranges::none_of(layouts, [&](const Job& job) {
                       return job.landscape->layout_key() == landscape.layout_key();
                   })) {
            layouts.push_back({one.want.landscape, Stage::Layout, {}, plot_of(landscape)});
        }
    }
    return layouts.empty() ? light : layouts;
}

std::vector<Job> Graph::next(std::size_t at_once, Urgency down_to) const {
    for (const Urgency urgency : {Urgency::Awaited, Urgency::Shown, Urgency::Coming, Urgency::Spare}) {
        if (urgency > down_to) break;
        // A newer wish need not wait for a long queue of older ones.
        std::vector<Job> jobs = missing_aspects(urgency);
        if (jobs.empty() && urgency == Urgency::Coming) jobs = missing_ahead();
        if (jobs.size() > at_once) jobs.erase(jobs.begin() + static_cast<std::ptrdiff_t>(at_once), jobs.end());
        if (jobs.empty()) jobs = missing_light(urgency);
        if (!jobs.empty()) return jobs;
    }
    return {};
}

// What ceased to be wanted while it was worked on goes at once.
void Graph::take(std::vector<Job> done) {
    const bool is_first_full = first_light(fineness_).light_px >= fineness_.light_px;
    for (Job& job : done) {
        if (job.grown) aspects_.keep(job.landscape->aspect_key(job.aspect), aspects_.now(), std::move(*job.grown));
        if (job.plot.layout) layouts_[job.landscape->layout_key()] = job.plot.layout;
        if (!job.lit) continue;
        Scene& scene = scenes_[job.landscape->key];
        if (job.stage == Stage::FullLight || is_first_full) scene.full = job.lit;
        if (job.stage == Stage::FirstLight) scene.first = job.lit;
    }
    forget();
}

bool Graph::has_unfinished_awaited() const {
    return std::ranges::any_of(wants_, [&](const Want& w) { return is_most_urgent(w) && !has(w); });
}

bool Graph::is_there() const {
    return std::ranges::all_of(wants_, [&](const Want& w) { return has(w); });
}

float Graph::progress() const {
    constexpr float kGrown = 0.9F;  // the rest is their light
    std::size_t all = 0, there = 0;
    for (const Want& want : wants_) {
        if (!is_most_urgent(want)) continue;
        const bool is_lit = find(*want.landscape).scene != nullptr;
        for (const Aspect aspect : genome::kAspects)
            there += is_lit || aspects_.contains(want.landscape->aspect_key(aspect)) ? 1 : 0;
        all += genome::kAspects.size();
    }
    if (!has_unfinished_awaited()) return 1;
    return kGrown * static_cast<float>(there) / static_cast<float>(all);
}

std::size_t Graph::to_grow() const {
    std::size_t sum = 0;
    for (const Urgency urgency : {Urgency::Awaited, Urgency::Shown, Urgency::Coming, Urgency::Spare})
        sum += missing_aspects(urgency).size();
    return sum;
}

Graph::Lit Graph::find(const Landscape& landscape) const {
    const auto found = scenes_.find(landscape.key);
    if (found == scenes_.end()) return {};
    const Scene& scene = found->second;
    return scene.full ? Lit{scene.full, true} : Lit{scene.first, false};
}

std::optional<Graph::AllLit> Graph::find(const Landscapes& landscapes) const {
    AllLit all;
    for (const auto& landscape : landscapes) {
        const Lit lit = find(*landscape);
        if (!lit.scene) return std::nullopt;
        all.is_full = all.is_full && lit.is_full;
        all.scenes.push_back(lit.scene);
    }
    return all;
}

Prospect Graph::ahead() const {
    Prospect prospect;
    for (const Foreseen& one : foreseen_) {
        const Landscape& landscape = *one.want.landscape;
        if (one.want.stage >= Stage::Layout && stands(landscape)) {
            const Plot plot = plot_of(landscape);
            const scene::Ground ground{plot.flora, plot.land};
            if (std::ranges::find(prospect.grounds, ground) == prospect.grounds.end())
                prospect.grounds.push_back(ground);
        }
        if (const Lit lit = find(landscape); lit.scene && !one.was_ordered) prospect.lit.push_back(lit.scene);
    }
    for (const Want& want : wants_)
        if (const Lit lit = find(*want.landscape); lit.scene && is_most_urgent(want)) prospect.lit.push_back(lit.scene);
    return prospect;
}

void Graph::remember_aspects(const std::vector<Want>& wants) {
    aspects_.pass_time();
    for (const Want& want : wants)
        for (const Aspect aspect : genome::kAspects)
            if (grows_alone(want, aspect)) aspects_.want(want.landscape->aspect_key(aspect));
}

void Graph::forget() {
    const auto is_foreseen = [&](Stage stage, const auto& is_it) {
        return std::ranges::any_of(foreseen_, [&](const Foreseen& one) {
            return !one.was_ordered && one.want.stage >= stage && is_it(*one.want.landscape);
        });
    };
    std::erase_if(layouts_, [&](const auto& entry) {
        const auto is_it = [&](const Landscape& landscape) { return landscape.layout_key() == entry.first; };
        return !is_in(wants_, entry.first) && !is_foreseen(Stage::Layout, is_it);
    });
    std::erase_if(scenes_, [&](const auto& entry) {
        const auto is_it = [&](const Landscape& landscape) { return landscape.key == entry.first; };
        return std::ranges::none_of(wants_, [&](const Want& w) { return is_it(*w.landscape); }) &&
               !is_foreseen(Stage::FirstLight, is_it);
    });
    aspects_.forget_old(kAspectsKept, [&](const AspectKey& key) {
        const Aspect aspect = std::get<0>(key);
        const auto needs = [&](const Want& want) {
            return grows_alone(want, aspect) && key == want.landscape->aspect_key(aspect) &&
                   find(*want.landscape).scene == nullptr;
        };
        return std::ranges::any_of(wants_, needs) ||
               std::ranges::any_of(foreseen_, [&](const Foreseen& one) { return needs(one.want); });
    });
}

}  // namespace quadrat::nursery
