// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "desk/http.hpp"
#include "desk/texts.hpp"

// What the curator says: forms as data, so that whoever knows the settings makes them and this room draws them.
namespace quadrat::desk {

struct Option {
    std::string value, label;
};

// One thing that can be said.
struct Entry {
    enum class Kind { Line, Lines, Number, Tick, Choice, Day, Range };
    Kind kind = Kind::Line;
    std::string name;   // of the form's field; of a range its two are NAME.low and NAME.high
    std::string label;  // in the page's language, or in `language`
    std::string value;  // of a tick "on" or ""; of a range "LOW HIGH", or ""
    std::string hint = {};
    std::string standard = {};             // what counts where nothing is written
    std::string language = {};             // of label and value; "": the page's
    std::vector<Option> options = {};      // of a choice
    double least = 0, most = 0, step = 1;  // of a number and a range
    std::string picture = {};              // address of one that shows what it is about; "": none
    std::string download = {};             // address of what may be kept of it, and what it is called; "": nothing
    std::string download_label = {};
    bool can_be_previewed = false;  // drawn by the exhibit, by its name
};

struct Group {
    std::string title;
    std::string hint = {};
    std::vector<Entry> entries = {};
};

// A part of what the curator says, one page.
struct Form {
    std::string part;  // "hours"; its title is the text "curator.PART"
    std::string hint = {};
    std::vector<Option> others = {};  // pages beside it: addresses, and what they are called
    std::string current = {};         // which of them it is; "" for none
    Fields kept = {};                 // that come along with the form as they are
    std::vector<Group> groups = {};
    std::string remove = {};  // what a button says that takes all of it out; "": there is none
};

// What can be taken back.
struct Change {
    std::string at, who, what;
};

// Any may throw InputError, whose words are shown; then nothing has changed.
struct Curator {
    std::function<std::vector<std::string>()> parts;  // in the order in which they are offered
    // As it is now; of some parts the query says which one of several. Nothing: there is no such part.
    std::function<std::optional<Form>(const std::string& part, const Fields& query, const Texts& say)> form;
    // False: nothing would be another. `removes`: by the form's button for that.
    enum class Deed { Save, Remove };
    std::function<bool(const std::string& part, const Fields& form, Deed deed, const std::string& who)> save;
    std::function<std::vector<Change>()> changes;                            // newest first
    std::function<std::optional<std::string>(const std::string& who)> undo;  // what was taken back; nothing: none
    std::function<void(const Fields& form, const std::string& entry)> ask_preview;
    std::function<std::optional<std::string>(const std::string& id)> landscape;  // PNG; /curator/landscape/ID.png
    std::function<std::optional<std::string>(const std::string& id)> postcard;   // PNG; /curator/postcard/ID.png
    std::function<std::optional<std::string>()> preview;  // PNG of what was asked for last, once the exhibit drew it
    // Until then: "visitor", somebody plays; "dark", nothing is shown; "soon"; "gone", no exhibit runs any more.
    std::function<std::string()> why_preview_waits;
};

}  // namespace quadrat::desk
