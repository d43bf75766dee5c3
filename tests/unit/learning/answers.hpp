// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "archive/word_answers.hpp"
#include "genome/speech.hpp"
#include "learning/school.hpp"

// Answers to learn from.
namespace quadrat::learning {

// What a visitor says who sees scenes as the map of now means them.
inline archive::WordAnswers sensible_answers(int count) {
    archive::WordAnswers answers;
    base::RandomStream chance{base::Seed{8}};
    for (int i = 0; i < count; ++i) {
        genome::WordAnswer answer;
        answer.made_of.emplace();
        for (const genome::Word& word : genome::vocabulary()) answer.made_of->set(word.id, chance.between(-0.9F, 0.9F));
        answer.word = genome::WordId::wet;
        answer.step = static_cast<std::size_t>(((*answer.made_of)[genome::WordId::wet] + 1) * 1.99F);
        answer.made_of->set(genome::WordId::wet, answer.value());
        answer.scene.values = breeding::default_word_map()(*answer.made_of);
        answer.scene.flight = base::Seed{static_cast<std::uint64_t>(i)};
        answers.readable.push_back(answer);
    }
    return answers;
}

inline bool learn(School& school, const archive::WordAnswers& answers) {
    school.begin(answers);
    school.wait();
    return school.take();
}

}  // namespace quadrat::learning
