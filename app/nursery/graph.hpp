// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "nursery/act.hpp"
#include "nursery/aspect_store.hpp"
#include "nursery/plot.hpp"

namespace quadrat::nursery {

// A landscape by what it grows from; its key is worked out once.
struct Landscape {
    genome::Candidate candidate;
    base::Seed flight;
    SceneKey key;
    const LayoutKey& layout_key() const { return std::get<0>(key); }
    const AspectKey& aspect_key(genome::Aspect aspect) const;
};
std::shared_ptr<const Landscape> landscape_of(genome::Candidate candidate, base::Seed flight);
using Landscapes = std::vector<std::shared_ptr<const Landscape>>;
Landscapes landscapes_of(const std::vector<genome::Candidate>& candidates, base::Seed flight);

// How far a landscape is to grow, each from the one before.
enum class Stage { Aspects, Layout, FirstLight, FullLight };

// Why it is wanted, the most urgent first.
enum class Urgency {
    Awaited,  // somebody waits for it
    Shown,    // it is on the screen in a first light
    Coming,   // it may be awaited next
    Spare     // when there is nothing else to do
};

struct Want {
    std::shared_ptr<const Landscape> landscape;
    Stage stage = Stage::FullLight;
    Urgency urgency = Urgency::Awaited;
    genome::PerAspect<bool> known{{true, true, true}};  // which of its aspects are certain; others are not grown
};
inline bool is_most_urgent(const Want& want) { return want.urgency == Urgency::Awaited; }
std::vector<Want> wants_for(const Landscapes& landscapes, Stage stage, Urgency urgency);

// A piece of work, and once it is done, what it made.
struct Job {
    std::shared_ptr<const Landscape> landscape;
    Stage stage;              // that it brings
    genome::Aspect aspect{};  // of Stage::Aspects
    Plot plot{};              // of the others: what there is already
    std::optional<Grown> grown{};
    std::shared_ptr<const scene::Scene> lit{};
};
void carry_out(Job& job, const scene::Fineness& fineness);

// What has grown of landscapes to come.
struct Prospect {
    std::vector<scene::Ground> grounds;  // that stand, until their scenes are shown in full light
    Scenes lit;                          // whole, in first light; of some of them at most four will be taken
};

// Everything that grows, addressed by what it grows from: equal keys are the same thing, however often it is wanted.
// Plans what is to be done next, and forgets what nobody wants; but for aspects, of which the last are kept. Pure: it
// grows nothing itself.
class Graph {
  public:
    // Aspects that are held at most: of the four on stage, and as many again for what is foreseen and for going back.
    static constexpr std::size_t kAspectsKept = 2 * genome::kCandidates * genome::kAspects.size();

    explicit Graph(const scene::Fineness& fineness) : fineness_(fineness) {}

    // In place of all that was wanted. What is foreseen and not among what is awaited now will not come.
    void want(std::vector<Want> wants);
    // In place of all that was foreseen; urgent as what is coming.
    void foresee(std::vector<Want> wants);
    // What is awaited is from now on wanted in its full light.
    void hurry();

    // The most urgent work, all of one stage: aspects and what is coming by so many, all light of the rest. Empty:
    // there is none that is as urgent as that.
    std::vector<Job> next(std::size_t at_once, Urgency down_to = Urgency::Spare) const;
    void take(std::vector<Job> done);

    bool has_unfinished_awaited() const;  // somebody waits for something that is not there yet
    bool is_there() const;                // all that is wanted, but for what is foreseen
    float progress() const;               // of what is awaited, 0 to 1
    std::size_t kept() const { return aspects_.size(); }
    std::size_t to_grow() const;  // aspects

    // The scene in the best light that there is; null where there is none. is_full: that is its full light.
    struct Lit {
        std::shared_ptr<const scene::Scene> scene;
        bool is_full = false;
    };
    Lit find(const Landscape& landscape) const;
    // All of them; nothing while one is missing. is_full: that all are.
    struct AllLit {
        Scenes scenes;
        bool is_full = true;
    };
    std::optional<AllLit> find(const Landscapes& landscapes) const;
    Prospect ahead() const;

  private:
    struct Foreseen {
        Want want;
        bool was_ordered = false;  // since it was foreseen; its ground is held until it is shown in full light
    };
    struct Scene {
        std::shared_ptr<const scene::Scene> first, full;
    };
    bool stands(const Landscape& landscape) const;
    bool has(const Want& want) const;
    Plot plot_of(const Landscape& landscape) const;
    void add_missing_aspects(const Want& want, genome::Aspect aspect, std::vector<Job>& jobs) const;
    std::vector<Job> missing_aspects(Urgency urgency) const;
    std::vector<Job> missing_light(Urgency urgency) const;
    std::vector<Job> missing_ahead() const;
    void remember_aspects(const std::vector<Want>& wants);
    void forget();

    scene::Fineness fineness_;
    std::vector<Want> wants_;
    std::vector<Foreseen> foreseen_;
    AspectStore aspects_;
    std::map<LayoutKey, std::shared_ptr<const synthesis::Layout>> layouts_;
    std::map<SceneKey, Scene> scenes_;
};

}  // namespace quadrat::nursery
