// SPDX-License-Identifier: Apache-2.0
// What the audience sees, screen by screen, with a site's settings:
//     screens_sheet 1920x1080 FOLDER [SETTINGS.toml]
// leaves a picture of each in the folder: every question, with the mark on each choice, captions, labels, the finale,
// what it offers, the family tree, the card of a closed house;
// one of them also as people see it who lack a kind of cone.
#include <fmt/core.h>

#include <filesystem>

#include "breeding/seeded_scene.hpp"
#include "display/options.hpp"
#include "genome/scene_code.hpp"
#include "genome/speech.hpp"
#include "pictures/picture.hpp"
#include "stage/easel.hpp"
#include "stage/spoken.hpp"
#include "stage/stage.hpp"
#include "support/colour_vision.hpp"

namespace {

using namespace quadrat;
using exhibit::Screen;

class Screens {
  public:
    Screens(display::Size size, std::filesystem::path folder, const site::Configuration& configuration)
        : folder_(std::move(folder)),
          configuration_(configuration),
          easel_(size.width, size.height),
          stage_(easel_.renderer(), configuration) {
        for (std::uint64_t i = 0; i < 4; ++i) {
            const auto scene =
                nursery::grow(breeding::seeded_scene(breeding::default_word_map(), base::Seed{i + 2}), {129, 128, 256});
            four_.scenes.push_back({scene, stage::upload_now(easel_.renderer(), scene)});
        }
        one_.scenes = {four_.scenes[1]};
    }

    void draw_all() {
        using exhibit::Choice;
        const genome::Language& language = genome::language(configuration_.visit.language);
        const std::optional<stage::Scanned> invites = stage::Scanned{{}, "invite.one"};
        draw("attract", Screen::Attract, one_, invites);
        draw("ask", Screen::Ask, four_);
        draw("ghost", Screen::Attract, one_, invites, std::chrono::milliseconds{9300});
        draw("ghost-down", Screen::Attract, one_, invites, std::chrono::milliseconds{9800});
        for (const auto marked : {Choice::A, Choice::B, Choice::C, Choice::D, Choice::Back})
            draw(fmt::format("scan-{}", static_cast<int>(marked)), Screen::Ask, four_,
                 stage::Scanned{marked, "scan.one", true});
        draw("scan-rest", Screen::Ask, four_, stage::Scanned{{}, "scan.rest", true});
        draw("hold", Screen::Ask, four_, stage::Scanned{{}, "hold.one", false, 0.6F});
        caption_ = "→ taller, sparser, wider crowns · wetter, more cliffs · warmer light";
        draw("breed", Screen::Breed, four_);
        caption_ = language.describe(genome::Description{});
        draw("finale", Screen::Finale, one_);
        asked_ = stage::Asked{"describe.land", language.answers(genome::WordId::undulating), std::nullopt};
        draw("describe", Screen::Describe, one_);
        draw("describe-scan", Screen::Describe, one_, stage::Scanned{Choice::B, "scan.two", true});
        draw("describe-back", Screen::Describe, one_, stage::Scanned{Choice::Back, "scan.two", true});
        asked_ = stage::Asked{"slide", {"←", "→", "−", "+"}, stage::ShownSlider{"dry", "wet", 0.7F}};
        draw("slide", Screen::Slide, one_, stage::Scanned{Choice::D, "scan.one", true});
        asked_ = stage::Asked{"ask.language", {"English", "Français", "العربية", "…"}, std::nullopt};
        draw("language", Screen::Language, one_);
        asked_.reset();
        draw("still-there", Screen::StillThere, four_);
        draw_company();
    }

  private:
    // What groups are told, what a finale offers, the family tree, what breeds on, and the card of a closed house.
    void draw_company() {
        timings_.turns = exhibit::TakingTurns::Always;
        draw("turns", Screen::Ask, four_);
        timings_ = {};
        timings_.can_breed_on = timings_.can_print = true;
        draw("breed-on", Screen::Attract, one_);
        family_ = {{-1, {}, true}};
        for (int round = 0; round < 4; ++round) {
            exhibit::Ancestor next{round, {}, round < 3};
            next.pick.each = {round % 4, (round + 1) % 4, (round + 1) % 4};
            family_.push_back(next);
        }
        family_.push_back({1, family_.back().pick, true});
        const stage::Spoken spoken(configuration_);
        for (const auto& [name, screen] : {std::pair{"finale-asks", Screen::Finale}, {"family", Screen::Family}}) {
            exhibit::State state = state_of(screen);
            asked_ = stage::asked_of(state, timings_, spoken, std::nullopt);
            draw(name, screen, one_,
                 screen == Screen::Finale ? std::nullopt : std::optional(stage::Scanned{exhibit::Choice::D, "", true}));
        }
        asked_.reset();
        board_ = stage::Board{site::text(configuration_, "closed"), {}, stage::Board::Cover::Tint, false, "closed"};
        draw("closed", Screen::Attract, one_);
        board_.reset();
    }
    exhibit::State state_of(Screen screen) const {
        exhibit::State state;
        state.screen = screen;
        state.question = genome::Aspect::Land;
        state.since = base::Instant{0};
        genome::Pick chosen;
        chosen.each = {1, 0, 3};
        if (screen == Screen::Breed) state.past_answers = {chosen};
        if (family_.empty()) return state;
        state.finale_asks = true;
        state.family = family_;
        state.here = 4;
        state.walked = screen == Screen::Family ? 1 : 4;
        return state;
    }
    void draw(const std::string& name, Screen screen, const stage::Cast& cast,
              const std::optional<stage::Scanned>& scanned = std::nullopt,
              base::Instant now = std::chrono::seconds{7}) {
        const exhibit::State state = state_of(screen);
        stage::StageView view{state, timings_, cast, flash_, 0.5F, now, caption_};
        view.board = board_ ? &*board_ : nullptr;
        view.asked = asked_ ? &*asked_ : nullptr;
        view.scanned = scanned ? &*scanned : nullptr;
        const std::string address = configuration_.take_home.url + genome::code_of(genome::Recipe{});
        if (!configuration_.take_home.url.empty()) view.take_home = address;
        const render::Frame frame = stage_.frame(view, easel_.display().begin_frame());
        easel_.renderer().draw(frame);
        const mesh::Image picture = easel_.renderer().read_pixels(frame);
        pictures::write_image(folder_ / (name + ".png"), picture);
        if (name != "scan-1") return;
        for (const tests::Vision& vision : tests::kVisions)
            pictures::write_image(folder_ / (name + "-" + vision.name + ".png"), tests::picture_seen(vision, picture));
    }

    std::filesystem::path folder_;
    const site::Configuration& configuration_;
    stage::Easel easel_;
    stage::Stage stage_;
    stage::Cast four_, one_;
    std::string caption_;
    std::optional<stage::Asked> asked_;
    exhibit::Timings timings_;
    std::vector<exhibit::Ancestor> family_;
    std::optional<stage::Board> board_;
    const std::optional<stage::Flash> flash_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3 && argc != 4) {
        fmt::print(stderr, "screens_sheet 1920x1080 FOLDER [SETTINGS.toml]\n");
        return 2;
    }
    try {
        const site::Configuration configuration = argc == 4 ? site::read_configuration(argv[3]) : site::Configuration{};
        std::filesystem::create_directories(argv[2]);
        Screens(display::size_from(argv[1], "the size"), argv[2], configuration).draw_all();
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
    return 0;
}
