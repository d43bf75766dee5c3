// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "breeding/session.hpp"
#include "breeding/words/own_word.hpp"

namespace quadrat::breeding {

// Breeding without pictures, one JSON object a line; what `quadrat breed --stdio` speaks. Pure: text in, text out, no
// line ends in either. The program prints hello() and offer() unprompted, then answer() of every line it reads.
//   {"pick":{"trees":2,"land":0,"sky":3}}   any aspect may be missing: it was not judged; {} judges nothing
//   {"undo":true}   {"lock":"trees"}   {"unlock":"trees"}   {"quit":true}
//   {"describe":{"wet":0.5}}            the word map's scene; words left out are free, own words may be among them
//   {"range":{"wet":[-0.5,1]}}          what a curator allows from the next round on; equal ends lock the word there
//   {"turn":{"wet":0.5}}                of the sliders: a word, or any parameter by its name; null frees a parameter
//   {"choose":"wet"}                    of the sliders: the one that the next pick of its aspect turns
//   {"state":true}                      the belief alone
// Same options, seed and lines: same bytes out, on every machine.
class StdioProtocol {
  public:
    static constexpr std::size_t kLongestLine = 65536;  // bytes

    // Own words can be described with beside those of the vocabulary.
    explicit StdioProtocol(Session session, std::vector<OwnWord> own_words = {});

    std::string hello() const;
    std::string offer() const;

    // The current offer, a scene, the state, or {"type":"error","line":N,"message":"…"} for whatever is not one of the
    // lines above; the session then goes on as it was. N counts the lines given to answer, from 1. A blank line is an
    // error too: every line in gives exactly one line out. Nothing, after {"quit":true} alone.
    std::optional<std::string> answer(std::string_view line);

  private:
    enum class Next { Offer, State, Scene, Quit };

    Next obey(std::string_view line);
    void undo();
    std::string scene(nlohmann::json words) const;

    Session session_;
    std::vector<OwnWord> own_words_;
    std::size_t lines_ = 0;
};

}  // namespace quadrat::breeding
