// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace quadrat::sound {

// Something to be said.
struct Utterance {
    std::string language;  // a code, "en", "zh", "de-AT"
    std::string key;       // what it is recorded under; "" where nobody can have recorded it
    std::string text;      // UTF-8
    friend bool operator==(const Utterance&, const Utterance&) = default;
};

// Speaks: by a recording FOLDER/LANGUAGE/KEY.wav where there is one, else by espeak-ng. That runs as a program of its
// own: a voice that crashes or hangs costs its sentence, and its licence stays its own.
class Speaker {
  public:
    explicit Speaker(std::filesystem::path folder, std::string program = "espeak-ng");

    // One channel at kRate; empty where it cannot be said. Takes a tenth of a second, a few at most: on its own thread.
    std::vector<float> say(const Utterance& utterance);
    const std::string& trouble() const { return trouble_; }  // why it could not, last; or ""

  private:
    std::filesystem::path folder_;  // may be empty
    std::string program_;
    std::string trouble_;
};

// espeak-ng's name for a language.
std::string voice_of(std::string_view language);

// As it can be read aloud: without arrows, dots of omission and what else is for eyes alone.
std::string readable(std::string_view text);

// About how long that takes to say, in seconds: for whoever has to wait for it without hearing it.
double speaking_time_s(const Utterance& utterance);

}  // namespace quadrat::sound
