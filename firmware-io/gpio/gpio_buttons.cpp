// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/gpio/gpio_buttons.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace quadrat::firmware_io::gpio {
namespace {

using namespace std::chrono_literals;

constexpr Instant kRetryEvery = 1s;
constexpr Instant kRetryMissingEvery = 10s;  // listing all lines of all chips is not free
// The levels are read again this often, so that an edge the kernel never reported cannot keep a button down.
constexpr Instant kReadLevelsEvery = 1s;

struct LinesOfChip {
    std::vector<unsigned> offsets;
    std::vector<Wire> wires;
};

std::string to_string(const Wire& wire) {
    std::string text{name_of(wire.button)};
    return text.append("=").append(to_string(wire.line));
}

// One line under two names, "0:17" and "GPIO17", is found out only here.
struct Taken {
    LinePlace place;
    const Wire* wire;
};
void require_free(std::vector<Taken>& taken, const LinePlace& place, const Wire& wire) {
    for (const Taken& other : taken)
        if (other.place == place)
            throw GpioError{to_string(*other.wire) + " and " + to_string(wire) +
                            " are the same line; give each button and lamp its own"};
    taken.push_back({place, &wire});
}

// Where the wires go, by chip. Those that go nowhere stay in `wires`, and `trouble` says why.
std::map<std::string, LinesOfChip> take_found(const std::vector<ChipFacts>& chips, std::vector<Wire>& wires,
                                              std::string& trouble) {
    std::map<std::string, LinesOfChip> found;
    std::vector<Wire> missing;
    std::vector<Taken> taken;
    for (const Wire& wire : wires) {
        try {
            const LinePlace place = find_line(chips, wire.line);
            require_free(taken, place, wire);
            found[place.chip_path].offsets.push_back(place.offset);
            found[place.chip_path].wires.push_back(wire);
        } catch (const GpioError& error) {
            trouble = error.what();
            missing.push_back(wire);
        }
    }
    wires = std::move(missing);
    return found;
}

void append(std::vector<Wire>& wires, const std::vector<Wire>& more) {
    wires.insert(wires.end(), more.begin(), more.end());
}

// Lines that cannot be had, and why: those with the same trouble in one sentence.
class Missing {
  public:
    void add(const Wire& wire, const std::string& said) {
        const std::string name = to_string(wire.line);
        const std::string beginning = "GPIO line " + name;
        const std::string why = said.substr(said.starts_with(beginning) ? beginning.size() : 0);
        const auto same = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& kind) { return kind.why == why; });
        if (same == kinds_.end())
            kinds_.push_back({why, name, false});
        else
            same->names.append(", ").append(name), same->is_many = true;
    }
    std::string sentences() const {
        constexpr std::string_view kIs = " is ";
        std::string text;
        for (const auto& [why, names, is_many] : kinds_) {
            text.append(text.empty() ? "GPIO line" : "; GPIO line").append(is_many ? "s " : " ").append(names);
            const bool is_singular = is_many && why.starts_with(kIs);
            text.append(is_singular ? " are " + why.substr(kIs.size()) : why);
        }
        return text;
    }

  private:
    struct Kind {
        std::string why, names;
        bool is_many;
    };
    std::vector<Kind> kinds_;
};

}  // namespace

GpioButtons::GpioButtons(std::unique_ptr<GpioHost> host, Wiring wiring)
    : host_{std::move(host)},
      wiring_{std::move(wiring)},
      debouncer_{wiring_.debounce},
      missing_contacts_{wiring_.contacts},
      missing_lamps_{wiring_.lamps},
      status_{Presence::Absent, "GPIO lines have not been requested yet"} {}

void GpioButtons::open_contacts(const std::vector<ChipFacts>& chips, Instant now) {
    for (auto& [path, found] : take_found(chips, missing_contacts_, trouble_)) {
        try {
            ContactBank bank{host_->request_inputs(path, found.offsets, wiring_.inputs), found.wires};
            if (!read_levels(bank, Levels::AtOpening, now)) throw GpioError{path + " vanished; plug it in again"};
            contact_banks_.push_back(std::move(bank));
        } catch (const GpioError& error) {
            trouble_ = error.what();
            append(missing_contacts_, found.wires);
        }
    }
}

void GpioButtons::open_lamps(const std::vector<ChipFacts>& chips) {
    for (auto& [path, found] : take_found(chips, missing_lamps_, trouble_)) {
        try {
            lamp_banks_.push_back({host_->request_outputs(path, found.offsets), found.wires, {}});
        } catch (const GpioError& error) {
            trouble_ = error.what();
            append(missing_lamps_, found.wires);
        }
    }
}

void GpioButtons::open(Instant now) {
    if (retry_at_ && now < *retry_at_) return;
    const std::vector<ChipFacts> chips = host_->chips();
    open_contacts(chips, now);
    open_lamps(chips);
    retry_at_ = now + (contact_banks_.empty() ? kRetryEvery : kRetryMissingEvery);
    describe();
}

void GpioButtons::describe() {
    status_ = {contact_banks_.empty() ? Presence::Absent : Presence::Present, {}};
    for (const ContactBank& bank : contact_banks_)
        for (const Wire& wire : bank.wires)
            status_.reason.append(status_.reason.empty() ? "GPIO lines " : ", ").append(to_string(wire));
    if (missing_contacts_.empty() && missing_lamps_.empty()) return;
    for (const Wire& wire : missing_contacts_)
        if (!status_.reason.empty()) status_.reason.append("; without ").append(to_string(wire));
    for (const Wire& wire : missing_lamps_)
        if (!status_.reason.empty()) status_.reason.append("; without lamp ").append(to_string(wire));
    status_.reason.append(status_.reason.empty() ? "" : ": ").append(trouble_);
}

void GpioButtons::lose(Instant now) {
    contact_banks_.clear();
    lamp_banks_.clear();
    missing_contacts_ = wiring_.contacts;
    missing_lamps_ = wiring_.lamps;
    clock_ = {};
    debouncer_.lost(now);
    retry_at_ = now + kRetryEvery;
    status_ = {Presence::Absent, "the GPIO chip has vanished; plug it in again (tried every second)"};
}

bool GpioButtons::read_levels(const ContactBank& bank, Levels when, Instant now) {
    const std::vector<bool> closed = bank.lines->closed();
    if (closed.size() != bank.wires.size()) return false;
    for (std::size_t i = 0; i < closed.size(); ++i) {
        if (when == Levels::AtOpening)
            debouncer_.found(bank.wires[i].button, closed[i], now);
        else
            debouncer_.contact(bank.wires[i].button, closed[i], now);
    }
    return true;
}

bool GpioButtons::read_edges(Instant now) {
    const bool is_time_for_levels = now - levels_read_at_ >= kReadLevelsEvery;
    if (is_time_for_levels) levels_read_at_ = now;
    for (const ContactBank& bank : contact_banks_) {
        std::vector<LineEdge> edges;
        const DrainEnd end = bank.lines->drain(edges);
        for (const LineEdge& edge : edges) clock_.saw(edge.kernel_time, now);
        for (const LineEdge& edge : edges)
            debouncer_.contact(bank.wires.at(edge.line).button, edge.is_closed, clock_.moment_of(edge.kernel_time));
        if (end == DrainEnd::Gone) return false;
        if ((is_time_for_levels || end == DrainEnd::Gap) && !read_levels(bank, Levels::AfterGap, now)) return false;
    }
    return true;
}

bool GpioButtons::drive_lamps(Instant now) {
    for (LampBank& bank : lamp_banks_) {
        std::vector<bool> lit;
        for (const Wire& wire : bank.wires) lit.push_back(is_lamp_lit(patterns_[index_of(wire.button)], now));
        if (lit == bank.lit) continue;
        if (bank.lines->set(lit) == OutputLines::Written::Gone) return false;
        bank.lit = std::move(lit);
    }
    return true;
}

SourceStatus GpioButtons::look() {
    const std::vector<ChipFacts> chips = host_->chips();
    std::string found;
    std::vector<Taken> taken;
    Missing missing;
    const auto look_for = [&](const Wire& wire, const char* what) {
        try {
            require_free(taken, find_line(chips, wire.line, kConsumer), wire);
            found.append(found.empty() ? "GPIO lines " : ", ").append(what).append(to_string(wire));
        } catch (const GpioError& error) {
            missing.add(wire, error.what());
        }
    };
    for (const Wire& wire : wiring_.contacts) look_for(wire, "");
    for (const Wire& wire : wiring_.lamps) look_for(wire, "lamp ");
    const std::string trouble = missing.sentences();
    return trouble.empty() ? SourceStatus{Presence::Present, found} : SourceStatus{Presence::Absent, trouble};
}

// A lamp that cannot be written to is found out by the next poll.
void GpioButtons::set_lamps(const Lamps& lamps) {
    patterns_ = lamps;
    drive_lamps(polled_at_);
}

std::vector<ButtonEdge> GpioButtons::poll(Instant now) {
    polled_at_ = now;
    if (!missing_contacts_.empty() || !missing_lamps_.empty()) open(now);
    if (!(read_edges(now) && drive_lamps(now))) lose(now);
    return debouncer_.take(now);
}

}  // namespace quadrat::firmware_io::gpio
