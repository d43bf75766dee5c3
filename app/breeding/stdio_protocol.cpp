// SPDX-License-Identifier: Apache-2.0
#include "breeding/stdio_protocol.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "genome/json_text.hpp"
#include "genome/pick_json.hpp"
#include "genome/speech.hpp"
#include "genome/values_json.hpp"
#include "genome/words_json.hpp"

namespace quadrat::breeding {
namespace {

using base::InputError;
using nlohmann::json;

// The source in the readers' messages; taken off again, since an error line has its number already.
constexpr std::string_view kSource = "line";
constexpr std::string_view kKnown =
    R"({"pick":{…}}, {"undo":true}, {"lock":ASPECT}, {"unlock":ASPECT}, {"describe":{…}}, {"range":{…}}, )"
    R"({"turn":{…}}, {"choose":NAME}, {"state":true} or {"quit":true})";

std::string in_quotes(std::string_view text) { return json(text).dump(-1, ' ', false, json::error_handler_t::replace); }

std::string parameter_json(const genome::Parameter& p) {
    return fmt::format(R"({{"name":{},"aspect":"{}","unit":{},"min":{},"max":{},"bits":{}}})", in_quotes(p.name),
                       name_of(p.aspect), in_quotes(p.unit), genome::shortest(p.min), genome::shortest(p.max), p.bits);
}

std::string candidate_json(const genome::Candidate& candidate, genome::Genome genome) {
    std::string text = fmt::format(R"({{"bits":{},"parameters":{},"words":{})", genome::bits_json(candidate.bits),
                                   values_json(candidate.values, genome),
                                   candidate.words ? genome::words_json(*candidate.words) : "{}");
    if (candidate.words)
        text += fmt::format(R"(,"sentence":{})", in_quotes(genome::language("en").describe(*candidate.words)));
    return text + "}";
}

// ,"words":[{"name":"wet","aspect":"land","low":"dry","high":"wet"},…]
std::string vocabulary_json() {
    std::vector<std::string> words;
    for (const genome::Word& word : genome::vocabulary())
        words.push_back(fmt::format(R"({{"name":"{}","aspect":"{}","low":"{}","high":"{}"}})", word.name,
                                    name_of(word.aspect), word.low, word.high));
    return fmt::format(R"(,"words":[{}])", fmt::join(words, ","));
}

// {"wet":[-0.5,1],…}
std::vector<std::pair<genome::WordId, WordRange>> ranges_from(const json& value) {
    if (!value.is_object()) throw InputError(fmt::format("{}: range should be an object of words", kSource));
    std::vector<std::pair<genome::WordId, WordRange>> ranges;
    for (const auto& [name, ends] : value.items()) {
        const auto id = genome::word_named(name);
        if (!id)
            throw InputError(fmt::format("{}: range names {}, which is no word", kSource, genome::brief(json(name))));
        const bool is_pair = ends.is_array() && ends.size() == 2 && ends[0].is_number() && ends[1].is_number();
        if (!is_pair || ends[0].get<double>() < -1 || ends[1].get<double>() > 1 || ends[0] > ends[1])
            throw InputError(fmt::format("{}: range.{} is {}; it should be [LOW,HIGH], from -1 to 1", kSource, name,
                                         genome::brief(ends)));
        ranges.emplace_back(*id, WordRange{ends[0].get<float>(), ends[1].get<float>()});
    }
    return ranges;
}

struct Turn {
    std::string name;
    std::optional<double> value;  // nothing for null
};

// {"wet":0.5}
Turn turn_from(const json& value) {
    if (!value.is_object() || value.size() != 1)
        throw InputError(fmt::format("{}: turn should be an object of one slider", kSource));
    const json& to = value.front();
    if (!to.is_number() && !to.is_null())
        throw InputError(fmt::format("{}: turn.{} is {}; it should be a number, or null", kSource,
                                     genome::brief(json(value.begin().key())), genome::brief(to)));
    return {value.begin().key(), to.is_null() ? std::nullopt : std::optional(to.get<double>())};
}

std::string text_from(const json& value, std::string_view key) {
    if (value.is_string()) return value.get<std::string>();
    throw InputError(fmt::format("{}: {} is {}; it should be a text", kSource, key, genome::brief(value)));
}

void require_true(const json& value, std::string_view key) {
    if (value != true)
        throw InputError(fmt::format(R"({}: {} is {}; write {{"{}":true}})", kSource, key, genome::brief(value), key));
}

genome::Aspect aspect_from(const json& value, std::string_view key) {
    const auto aspect = value.is_string() ? genome::aspect_named(value.get_ref<const std::string&>()) : std::nullopt;
    if (!aspect)
        throw InputError(
            fmt::format("{}: {} is {}; an aspect is trees, land or sky", kSource, key, genome::brief(value)));
    return *aspect;
}

json request_from(std::string_view line) {
    if (line.size() > StdioProtocol::kLongestLine)
        throw InputError(fmt::format("{}: the line is longer than {} bytes", kSource, StdioProtocol::kLongestLine));
    if (line.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw InputError(fmt::format("{}: the line is blank; write {}", kSource, kKnown));
    json request = genome::parse_json(line, kSource);
    if (!request.is_object() || request.empty())
        throw InputError(fmt::format("{}: {} is no request; write {}", kSource, genome::brief(request), kKnown));
    if (request.size() > 1) {
        std::vector<std::string> keys;
        for (const auto& entry : request.items()) keys.push_back(genome::brief(json(entry.key())));
        if (keys.size() > 8) keys.resize(8);
        throw InputError(fmt::format("{}: the line has {} keys ({}); write one a line", kSource, request.size(),
                                     fmt::join(keys, ", ")));
    }
    return request;
}

// "line: what" and "line:1: what" are "what" to the reader of an error line.
std::string_view without_source(std::string_view message) {
    for (const std::string_view lead : {"line: ", "line:1: "})
        if (message.substr(0, lead.size()) == lead) return message.substr(lead.size());
    return message;
}

}  // namespace

StdioProtocol::StdioProtocol(Session session, std::vector<OwnWord> own_words)
    : session_(std::move(session)), own_words_(std::move(own_words)) {}

std::string StdioProtocol::hello() const {
    const genome::Genome genome = session_.breeder().genome();
    std::vector<std::string> parameters;
    for (const genome::Aspect aspect : genome::kAspects)
        for (const genome::ParameterId id : parameters_of(aspect, genome))
            parameters.push_back(parameter_json(genome::parameter(id)));
    std::string words;
    if (session_.offer().candidates.front().words) words = vocabulary_json();
    return fmt::format(
        R"({{"type":"hello","genome":"{}","breeder":"{}","seed":{},"aspects":["trees","land","sky"],"parameters":[{}]{}}})",
        genome == genome::Genome::Classic ? "classic" : "words", session_.breeder().name(), session_.seed().value,
        fmt::join(parameters, ","), words);
}

std::string StdioProtocol::offer() const {
    const genome::Offer& offer = session_.offer();
    std::vector<std::string> candidates;
    for (const genome::Candidate& candidate : offer.candidates)
        candidates.push_back(candidate_json(candidate, session_.breeder().genome()));
    return fmt::format(R"({{"type":"offer","round":{},"candidates":[{}],"state":{}}})", offer.round,
                       fmt::join(candidates, ","), session_.breeder().state_json());
}

std::optional<std::string> StdioProtocol::answer(std::string_view line) {
    ++lines_;
    try {
        switch (obey(line)) {
            case Next::Offer:
                return offer();
            case Next::State:
                return fmt::format(R"({{"type":"state","state":{}}})", session_.breeder().state_json());
            case Next::Scene:
                return scene(request_from(line).front());
            case Next::Quit:
                break;
        }
        return std::nullopt;
    } catch (const InputError& error) {
        return fmt::format(R"({{"type":"error","line":{},"message":{}}})", lines_,
                           in_quotes(without_source(error.what())));
    }
}

StdioProtocol::Next StdioProtocol::obey(std::string_view line) {
    const json request = request_from(line);
    const std::string& key = request.begin().key();
    const json& value = request.front();
    if (key == "pick") {
        session_.next(genome::pick_from(value, kSource, "pick"));
    } else if (key == "undo") {
        require_true(value, key);
        undo();
    } else if (key == "lock" || key == "unlock") {
        session_.set_lock(aspect_from(value, key), key == "lock" ? Lock::Locked : Lock::Open);
    } else if (key == "turn") {
        const Turn turn = turn_from(value);
        session_.turn(turn.name, turn.value, kSource);
    } else if (key == "choose") {
        session_.choose(text_from(value, key), kSource);
    } else if (key == "describe") {
        return Next::Scene;
    } else if (key == "range") {
        for (const auto& [word, range] : ranges_from(value)) session_.set_range(word, range);
    } else if (key == "state") {
        require_true(value, key);
        return Next::State;
    } else if (key == "quit") {
        require_true(value, key);
        return Next::Quit;
    } else {
        throw InputError(
            fmt::format("{}: the key {} is not known; write {}", kSource, genome::brief(json(key)), kKnown));
    }
    return Next::Offer;
}

std::string StdioProtocol::scene(json words) const {
    const WordMap& map = session_.breeder().word_map();
    std::vector<Direction> along;
    for (const OwnWord& own : own_words_) {
        if (!words.is_object() || !words.contains(own.name)) continue;
        const json& value = words[own.name];
        if (!value.is_number() || value.get<double>() < -1 || value.get<double>() > 1)
            throw InputError(fmt::format("{}: describe.{} is {}; a word is a number from -1 to 1", kSource, own.name,
                                         genome::brief(value)));
        along.push_back(own.at(value.get<double>()));
        words.erase(own.name);
    }
    const genome::Description description =
        map.completed(genome::partial_words_from(words, kSource, "describe"), along);
    return fmt::format(R"({{"type":"scene","words":{},"sentence":{},"parameters":{}}})",
                       genome::words_json(description), in_quotes(genome::language("en").describe(description)),
                       values_json(map(description), genome::Genome::Full));
}

void StdioProtocol::undo() {
    if (session_.undo()) return;
    if (session_.offer().round == 1) throw InputError(fmt::format("{}: nothing to undo in the first round", kSource));
    throw InputError(
        fmt::format("{}: nothing to undo; only the last {} rounds are kept", kSource, Session::kUndoDepth));
}

}  // namespace quadrat::breeding
