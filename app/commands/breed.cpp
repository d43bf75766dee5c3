// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <string>

#include "base/error.hpp"
#include "base/text_file.hpp"
#include "breeding/stdio_protocol.hpp"
#include "commands/commands.hpp"
#include "learning/school.hpp"
#include "site/state_folder.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    bool is_stdio = false;
    std::string genome = "words";
    std::string breeder;  // empty: belief in words, PBIL in the classic genome
    std::uint64_t seed = 1;
    double learning_rate = breeding::PbilOptions{}.learning_rate;
    double mutation = breeding::PbilOptions{}.mutation;
    std::string mutation_form = "toward-half";
    std::vector<std::string> locked;
    std::vector<std::string> own_words;
    std::string state;
};

breeding::Session session_for(const Options& options) {
    breeding::BreederOptions breeder;
    const bool is_classic = options.genome == "classic";
    breeder.kind = breeding::breeder_named(!options.breeder.empty() ? options.breeder : is_classic ? "pbil" : "belief");
    if (!options.state.empty()) breeder.map = learning::site_words(site::existing_state_folder(options.state)).map;
    breeder.genome = is_classic ? genome::Genome::Classic : genome::Genome::Full;
    breeder.pbil.learning_rate = options.learning_rate;
    breeder.pbil.mutation = options.mutation;
    breeder.pbil.mutation_form =
        options.mutation_form == "random" ? breeding::MutationForm::Random : breeding::MutationForm::TowardHalf;
    breeding::Breeder learner(breeder);
    for (const std::string& name : options.locked)
        learner.set_lock(genome::aspect_named(name).value(), breeding::Lock::Locked);
    return {std::move(learner), base::Seed{options.seed}};
}

// A line longer than the protocol allows is refused by it; what lies beyond is dropped here, so that a stream without
// line ends cannot fill the memory.
bool read_line(std::string& line) {
    line.clear();
    for (int c = std::cin.get(); c != std::char_traits<char>::eof(); c = std::cin.get()) {
        if (c == '\n') return true;
        if (line.size() <= breeding::StdioProtocol::kLongestLine) line += static_cast<char>(c);
    }
    return !line.empty();
}

int breed(const Options& options) {
    if (!options.is_stdio)
        throw base::InputError("breed: say how to speak to it: quadrat breed --stdio (one JSON object a line)");
    breeding::Session session = session_for(options);
    std::vector<breeding::OwnWord> own;
    for (const std::string& file : options.own_words)
        own.push_back(
            breeding::own_word_from(base::read_text(file, base::kJsonLimits), file, session.breeder().word_map()));
    breeding::StdioProtocol protocol(std::move(session), std::move(own));
    std::cout << protocol.hello() << '\n' << protocol.offer() << std::endl;
    for (std::string line; read_line(line);) {
        const auto answer = protocol.answer(line);
        if (!answer) break;
        std::cout << *answer << std::endl;
        if (!std::cout) break;
    }
    return 0;
}

}  // namespace

void add_breed(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("breed", "Breed without pictures: picks in, candidates out");
    command.add_flag("--stdio", options->is_stdio, "Speak one JSON object a line on standard input and output");
    command
        .add_option("--genome", options->genome,
                    "words: the whole table, bred in words; classic: the 21 parameters and 70 bits of 2003")
        .among({"words", "classic"})
        .shows_default();
    command
        .add_option(
            "--breeder", options->breeder,
            "belief (default in words), pbil (default in the classic genome), pbil-gaussian, random, or sliders")
        .among({"belief", "pbil", "pbil-gaussian", "random", "sliders"})
        .tells_default("belief in words, pbil in the classic genome");
    command.add_option("--seed", options->seed, "Names all chance").shows_default();
    command.add_option("--learning-rate", options->learning_rate, "Weight of the best candidate's bits, 0 to 1")
        .between(0.0, 1.0)
        .shows_default();
    command.add_option("--mutation", options->mutation, "Weight of 0.5, or of chance, 0 to 1")
        .between(0.0, 1.0)
        .shows_default();
    command.add_option("--mutation-form", options->mutation_form, "toward-half or random")
        .among({"toward-half", "random"})
        .shows_default();
    command.add_option("--lock", options->locked, "An aspect that keeps what it knows: trees, land, sky; repeatable")
        .among({"trees", "land", "sky"})
        .tells_default("none");
    command
        .add_option("--own-word", options->own_words,
                    "A word of one's own that scenes may be described with: FILE.json, see words own; repeatable")
        .tells_default("none");
    command.add_option("--state", options->state, "The exhibit's state folder, for the map that its site has trained")
        .tells_default("the map that comes along");
    command.does([options] { return breed(*options); });
}

}  // namespace quadrat::commands
