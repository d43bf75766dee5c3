// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>
#include <vector>

#include "firmware-io/gpio/find_line.hpp"
#include "site/configuration.hpp"
#include "site/configuration_reader.hpp"

// What the texts of a configuration must be to be of use. Each check throws std::exception with "what is wrong; what
// would be right"; empty texts stand for the default and are right.
namespace quadrat::site {

void check_size(const std::string& text);
void check_mode(const std::string& text);
void check_connector(const std::string& text);
void check_power(const std::string& address);
void check_broker(const std::string& address);
void check_listen_address(const std::string& text);
void check_take_home(const std::string& url);
void check_fleet_name(const std::string& name);
void check_fleet_user(const std::string& name);
void check_folder(const std::string& path);
void check_sound_device(const std::string& name);  // by its form: a card may come later
void check_words(const std::string& words, const LettersWithoutFont& without_font);  // that the screen can show
void check_printer(const std::string& name);
void check_code(const std::string& code);
void check_topic_prefix(const std::string& prefix);
void check_file(const std::string& path);  // it is there; who may read it is not asked

// The inputs of one list, one after the other: no line of a GPIO chip is in two of them. A script is read too.
class InputCheck {
  public:
    void operator()(const std::string& spec);

  private:
    std::vector<firmware_io::gpio::LineAddress> lines_;
};

// The screen's own words, and those of the language, as far as the fonts reach.
void read_texts(ConfigurationReader& reader, Configuration& configuration, const LettersWithoutFont& without_font);
// Those of a table that has one for each language's code; `name` is the table's.
void read_texts_in(ConfigurationReader& reader, const toml::table& table, const std::string& name,
                   TextsByLanguage& texts, const LettersWithoutFont& without_font);
void check_zone(const std::string& name);
void check_language(ConfigurationReader& reader, const Configuration& configuration,
                    const LettersWithoutFont& without_font);

// The letters that the screen's prompts need and no installed font has.
std::string letters_missing_for(const Configuration& configuration, const LettersWithoutFont& without_font);

}  // namespace quadrat::site
