// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "base/worker.hpp"
#include "pictures/postcard.hpp"
#include "site/configuration.hpp"
#include "stage/theatre.hpp"

namespace quadrat::staff {

// A card of the site's without its landscape: what it is in words and its code, in the language that was spoken.
pictures::Postcard blank_card(const site::Configuration& configuration, std::string title, std::string code,
                              const std::string& language);

// Gives a card to a CUPS printer, by lp, which has to be done within half a minute. "": it was taken; else why not.
// Waits for it. The card is a file for as long as lp takes to read it.
std::string print(const mesh::Image& card, const std::string& printer, const std::string& program = "lp");

// Postcards of finales, on the site's printer. No frame waits for paper: what cannot be printed is said, once for each
// kind of trouble, and forgotten. One at a time; another that is wished for meanwhile is not printed.
class Postcards {
  public:
    explicit Postcards(const site::Configuration& configuration) : configuration_(configuration) {}

    // Of the landscape that is on show. Of no effect without a printer.
    void wish(std::string title, std::string code, const std::string& language);
    // Once a frame, before it is drawn: draws over the canvas once where a card was wished for.
    void look(stage::Theatre& theatre, const nursery::Act& finale, const display::Canvas& canvas);
    const std::string& trouble() const { return trouble_; }  // of the last card; "": none

  private:
    void hear_of_the_last();

    const site::Configuration& configuration_;
    std::optional<pictures::Postcard> card_;  // without its landscape
    bool is_begun_ = false;                   // that is on its way
    std::string trouble_;
    base::Worker printer_{{.name = "postcards"}};
    base::Begun<std::string> printing_;  // why not, or ""; last: what prints uses none of the rest
};

}  // namespace quadrat::staff
