// SPDX-License-Identifier: Apache-2.0
#include <span>

#include "firmware-io/scripted/script.hpp"
#include "firmware-io/text.hpp"

namespace quadrat::firmware_io::scripted {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::string_view kActions =
    "press B, hold C for 3s, chord A+B, bounce B 12 edges over 8ms, release, wait 30s, unplug or plug";

Button button_of(std::string_view word) {
    if (const auto button = button_named(word)) return *button;
    throw ScriptError{quoted(word) + " is not a button; a button is A, B, C, D or Back"};
}

Instant duration_of(std::string_view word) {
    if (const auto span = parse_duration(word)) return *span;
    throw ScriptError{quoted(word) + " is not a time; write 2.5s, 80ms, 500us, 2min or 1h (at most 1000h)"};
}

void expect(bool is_right, std::string_view example) {
    if (!is_right) throw ScriptError{"these words do not make an action; write \"" + std::string{example} + "\""};
}

void parse_hold(Words words, ScriptWriter& writer) {
    expect(words.size() == 2 || (words.size() == 4 && words[2] == "for"), "hold C for 3s");
    if (words.size() == 2)
        writer.hold(button_of(words[1]));
    else
        writer.hold(button_of(words[1]), duration_of(words[3]));
}

void parse_chord(Words words, ScriptWriter& writer) {
    expect(words.size() == 2 || (words.size() == 4 && words[2] == "for"), "chord A+B for 300ms");
    std::vector<Button> buttons;
    for (const std::string_view name : split(words[1], '+')) buttons.push_back(button_of(name));
    expect(buttons.size() > 1, "chord A+B");
    writer.chord(buttons, words.size() == 4 ? duration_of(words[3]) : kCleanPress);
}

void parse_bounce(Words words, ScriptWriter& writer) {
    expect(words.size() == 6 && words[3] == "edges" && words[4] == "over", "bounce B 12 edges over 8ms");
    const auto edges = parse_unsigned(words[2]);
    if (!edges || *edges > kMostEvents)
        throw ScriptError{quoted(words[2]) + " is not a number of edges; write 0 to " + std::to_string(kMostEvents)};
    writer.bounce(button_of(words[1]), *edges, duration_of(words[5]));
}

void parse_release(Words words, ScriptWriter& writer) {
    expect(words.size() <= 2, "release C");
    if (words.size() == 2)
        writer.release(button_of(words[1]));
    else
        writer.release();
}

void parse_action(Words words, ScriptWriter& writer) {
    const std::string_view verb = words.front();
    if (verb == "press") {
        expect(words.size() == 2, "press B");
        writer.press(button_of(words[1]));
    } else if (verb == "wait") {
        expect(words.size() == 2, "wait 30s");
        writer.wait(duration_of(words[1]));
    } else if (verb == "unplug" || verb == "plug") {
        expect(words.size() == 1, verb);
        verb == "plug" ? writer.plug() : writer.unplug();
    } else if (verb == "hold") {
        parse_hold(words, writer);
    } else if (verb == "chord") {
        parse_chord(words, writer);
    } else if (verb == "bounce") {
        parse_bounce(words, writer);
    } else if (verb == "release") {
        parse_release(words, writer);
    } else {
        throw ScriptError{quoted(verb) + " is not an action; write " + std::string{kActions}};
    }
}

void parse_line(Words words, ScriptWriter& writer) {
    if (words.front() == "at" || words.front() == "after") {
        const bool is_absolute = words.front() == "at";
        expect(words.size() > 2, is_absolute ? "at 2.5s press B" : "after 400ms press A");
        is_absolute ? writer.at(duration_of(words[1])) : writer.wait(duration_of(words[1]));
        words = words.subspan(2);
    }
    parse_action(words, writer);
}

}  // namespace

Script parse_script(std::string_view text, std::string_view source_name) {
    ScriptWriter writer;
    std::size_t number = 0;
    for (const std::string_view line : split(text, '\n')) {
        ++number;
        const auto words = words_of(line.substr(0, line.find('#')));
        if (words.empty()) continue;
        try {
            parse_line(words, writer);
        } catch (const ScriptError& error) {
            throw ScriptError{std::string{source_name} + ":" + std::to_string(number) + ": " + error.what()};
        }
    }
    return writer.script();
}

}  // namespace quadrat::firmware_io::scripted
