// SPDX-License-Identifier: Apache-2.0
// The room `site`: what one place decides and where it keeps it. Settings and their checks, opening hours, the wall
// clock, the state folder. Nothing here draws, grows or runs: it says what is wanted.
#pragma once
#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/coverage.hpp"
#include "site/hours.hpp"
#include "site/mistake.hpp"
#include "site/themes.hpp"

namespace quadrat::site {

// What the people of one site decide, from a TOML file; deploy/quadrat.toml shows every key with its default.
// Everything has a default: no file at all is a working exhibit.
struct Configuration {
    struct Screen {
        std::string display = "auto";  // auto, kms, window, headless
        std::string size;              // drawn size, "1280x720"; empty: the screen's
        std::string connector;         // kms: "HDMI-A-1"; empty: the first with a screen
        std::string mode;              // kms: "1920x1080@60"; empty: the screen's own size
        int rotation_deg = 0;          // 0, 90, 180, 270 clockwise
        bool is_mirrored = false;      // rear projection
        // What shows the picture is switched by: "cec", "pjlink://192.168.0.30" (projector/projector.hpp); "": nobody.
        std::string power;
        std::string power_password_file;  // PJLink's, its first line
    } screen;

    std::vector<std::string> inputs;  // button specs: "gpio:A=GPIO17,…", "hid:", "keyboard", "script:FILE"

    struct Visit {
        int rounds = 6;               // 1 to 50
        int rounds_early = 2;         // so many fewer when picks agree, 0 to 10; where there are four at least
        int rounds_more = 2;          // so many more while they change, 0 to 10; likewise
        std::string turns = "found";  // a group is invited to take turns: found, always, never
        bool shows_family = true;     // the finale offers the family tree, and to go on
        double patience_s = 25;       // without a press, until "Still there?"
        double countdown_s = 10;      // of "Still there?"
        double finale_s = 20;
        double long_press_s = 2;       // of any choice button: to the finale
        int describe_words = 3;        // asked after a finale, one at a time; 0: none are
        int describe_every = 2;        // of every so many finales
        bool describe_others = false;  // not what was bred, but landscapes that lie evenly over the words
        double describe_s = 15;        // without a press, until the visitor is taken to have left
        std::string language = "en";   // that the screen speaks
        // Of the site's own languages, CODE.json or CODE.po; read when the program starts. "": none.
        std::string language_folder;
        std::vector<std::string>
            languages;  // that a visitor may choose from as they come; fewer than two: nobody is asked
        std::string theme = kThemeByDate;  // or the name of one, or kNoTheme
    } visit;

    // For who cannot use four buttons.
    struct Play {
        std::string buttons = "four";  // four, two, one: with so many everybody plays
        std::string held = "one";      // one, two: with so many who holds a button, until the visit ends
        double hold_s = 4;             // so long, 1 to 9; 0: nobody can ask for it
        double pace_s = 2;             // a choice is marked so long, 0.3 to 30
        int times_round = 3;           // then the mark rests until a press; 0: it never does
        bool begins_by_itself = true;  // the mark, with each question
        double dwell_s = 0;            // what a press has marked is taken after so long, 0.5 to 30; 0: never
        double quiet_s = 0.4;          // after a press another does not count, 0 to 5
        double patience = 3;           // how many times as long everything waits, 1 to 20
        bool shows_how = true;         // ghostly presses, now and then while nobody is there
    } play;

    // What is heard. Off, because a room of exhibits is loud enough, unless the site decides otherwise.
    struct Sound {
        bool is_on = false;
        double level = 0.5;              // 0 to 1: nothing is ever louder
        double soundscape = 0.6;         // 0 to 1, of that: the landscape's; 0: none
        double signals = 1;              // 0 to 1, of that: of presses, choices and rounds
        bool speaks = false;             // questions, and the four in words
        std::string speech_folder;       // recordings, LANGUAGE/KEY.wav, in place of espeak-ng
        std::string device = "default";  // ALSA's name of the card
        std::string private_device;      // of a handset: then speech is heard there alone; "": there is none
        double private_level = 0.5;      // 0 to 1, at the start of a visit
        friend bool operator==(const Sound&, const Sound&) = default;
    } sound;

    struct Breeding {
        std::string genome = "words";               // words, classic
        std::string breeder = "belief";             // belief, pbil, pbil-gaussian, random, sliders
        bool learns_taste = true;                   // belief in words: begins nearer to what visitors end up with
        double learning_rate = 0.2;                 // 0 to 1
        double mutation = 0.02;                     // 0 to 1
        std::string mutation_form = "toward-half";  // toward-half, random
        std::vector<std::string> locked;            // aspects that never move: trees, land, sky
        int control_every = 0;  // of so many visits one is bred by chance alone, unannounced; belief in words; 0: none
    } breeding;

    // What a word may be, by its name: two numbers from -1 to 1; the same twice locks it there.
    std::map<std::string, std::array<double, 2>> words;

    struct Picture {
        double alpha = 1;        // detail
        int samples = 4;         // a pixel, at most, where there is time for them: 1, or 4 for smooth edges
        int land_samples = 513;  // a side of the land, 2^k + 1: 129 grows in a tenth of the time, and is smoother
        std::string ground = "blocks";  // what draws the land: blocks, roam
    } picture;

    // For eyes that see less, and for those whom movement troubles.
    struct Look {
        std::string size = "normal";      // of letters and signs: normal, large, largest
        std::string contrast = "normal";  // normal, high
        std::string motion = "full";      // full; calm: cameras stand still, and what comes fades in
        // Beside the words, for who does not read: beside; instead of them: alone; none.
        std::string pictograms = "beside";
        friend bool operator==(const Look&, const Look&) = default;
    } look;

    // A code of the landscape, to be taken home from the finale; none, unless there is where to.
    struct TakeHome {
        std::string url;  // "https://museum.example/quadrat/", the code comes after it
        friend bool operator==(const TakeHome&, const TakeHome&) = default;
    } take_home;

    // Finales on paper; none without a printer.
    struct Postcard {
        std::string printer;         // as CUPS names it, lpstat -p
        std::string when = "asked";  // asked, always
        std::string place;           // below the picture, beside the date; "": the date alone
        friend bool operator==(const Postcard&, const Postcard&) = default;
    } postcard;

    // What of the landscapes that visitors bred is shown while nobody plays; by their codes (genome/scene_code.hpp).
    struct Attract {
        static constexpr std::size_t kMostFavourites = 12, kMostHidden = 100;
        std::vector<std::string> favourites;  // shown in turn, besides the newest
        std::vector<std::string> hidden;      // never shown again
        bool breeds_on = true;                // button D breeds on from what is shown
        bool has_year = true;                 // the newest is shown in all four seasons
        bool is_wall = false;                 // nobody plays; no setting: quadrat run --gallery
        std::vector<std::string> guests;      // of other exhibits; said by no file of settings, but by who takes them
        friend bool operator==(const Attract&, const Attract&) = default;
    } attract;

    // Where health and visits are published; nowhere, unless a broker is named.
    struct Fleet {
        std::string broker;         // "mqtts://broker.example:8883", "mqtt://…"
        std::string name;           // of this exhibit; the machine's, without one
        std::string user;           // for the broker
        std::string password_file;  // its first line
        std::string ca_file;        // who vouches for the broker; the system's, without one
        bool takes_orders = false;  // from whoever the broker lets write to quadrat/NAME/set/…
        std::string discovery;      // the prefix below which Home Assistant looks; "": it is told nothing
        // With the other exhibits at the broker: nothing; favourites, that staff chose; bred, also what was bred last.
        std::string shares = "nothing";
        // Of what they share: nothing; chosen, what staff choose of it; all, but what staff hide.
        std::string takes = "nothing";
        friend bool operator==(const Fleet&, const Fleet&) = default;
    } fleet;

    // A page for those who look after the exhibit; none, unless it listens somewhere.
    struct Desk {
        std::string listen;       // "127.0.0.1:8080", "[::1]:8080"
        std::string certificate;  // and the key to it, PEM; needed wherever other machines reach it
        std::string key;
        friend bool operator==(const Desk&, const Desk&) = default;
    } desk;

    Hours hours;                // when the house is open; always, unless it says
    DoorkeeperOptions closing;  // what happens at closing time
    std::string zone;           // that the hours are meant in, "Europe/Berlin"; the machine's, without one

    std::map<std::string, std::string> texts;  // prompts in the site's own words and language, by key
    TextsByLanguage texts_in;                  // the same for each language; where both are, these count

    std::map<std::string, Theme> themes;  // by name; see with_theme()
};

// Whether somebody chooses among what visitors bred, shares it, or may look for it after the finale's code.
inline bool collects_bred(const Configuration& configuration) {
    return !configuration.desk.listen.empty() || configuration.fleet.shares == "bred" ||
           !configuration.take_home.url.empty();
}

// Which letters of a text cannot be shown, "" for none: render::letters_without_font.
using LettersWithoutFont = std::function<std::string(const std::string& utf8)>;

// A configuration, and all that is wrong with what it was read from. Where something is, what is right is in it, and
// the defaults for the rest.
struct CheckedConfiguration {
    Configuration configuration;
    std::vector<Mistake> mistakes;  // by line
    bool is_usable() const { return mistakes.empty(); }
};

// The one judgement of settings: whoever reads them, to run, to publish, to follow them or to look after them, comes
// here. An empty text is a mistake, as what a pulled plug leaves of a file; one with nothing but comments is not. A
// text may have two layers (layers.hpp): then the lower one is right by itself too.
CheckedConfiguration check_configuration(std::string_view toml, const std::string& source,
                                         const LettersWithoutFont& without_font = render::letters_without_font);
// The same for a file. One that cannot be read is a mistake too. `toml` receives what it holds, or nothing.
CheckedConfiguration check_configuration_file(const std::filesystem::path& path,
                                              std::optional<std::string>* toml = nullptr);

// The same for those who refuse settings with any mistake: throws SettingsError with all of them.
Configuration configuration_from(std::string_view toml, const std::string& source);
Configuration read_configuration(const std::filesystem::path& path);

// The prompt for a key of genome::kPrompts in a language, "" for the site's: there in the site's own words, if it has
// some.
std::string text(const Configuration& configuration, const std::string& key, std::string_view language = {});

}  // namespace quadrat::site
