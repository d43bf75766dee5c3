// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text_file.hpp"
#include "commands/commands.hpp"
#include "commands/progress.hpp"
#include "pictures/image_file.hpp"
#include "pictures/mask.hpp"
#include "pictures/picture.hpp"
#include "pictures/relief.hpp"
#include "synthesis/land/constraint_text.hpp"
#include "synthesis/land/deformations.hpp"
#include "synthesis/land/erosion.hpp"
#include "synthesis/land/field_methods.hpp"
#include "synthesis/land/masks.hpp"

namespace quadrat::commands {
namespace {

namespace land = synthesis::land;
using synthesis::noise::Window;

struct Options {
    std::string method;
    std::string output;
    int size = 513;
    std::uint64_t seed = 1;
    float features = 0;  // 0: 4, or 1 with pictures
    int octaves = 9;
    float gain = 0.5F;
    std::string window;
    std::string fix_file;
    std::string line_file;
    std::string mask_file;
    std::string mask_range;
    std::optional<float> mask_nodata;
    std::vector<float> mask_heights{-1, 1};
    int mask_reach = 0;  // 0: a thirty-second of the size
    float search = 0;    // cost that a search may leave; 0: no search
    int search_most = 400;
    std::vector<std::string> with;
    std::string with_range;
    std::vector<float> range{-2, 2};
    float burrs = 0;
    int smooth = 0;
    int erode = 0;
    float repose_deg = 0;
    bool is_relief = false;

    bool has_filters() const { return burrs > 0 || smooth > 0 || erode > 0 || repose_deg > 0; }
    bool needs_the_whole() const { return has_filters() || !mask_file.empty(); }
};

Window window_from(const std::string& text, int size) {
    if (text.empty()) return {0, 0, size, size};
    Window w;
    char rest = 0;
    const int read = std::sscanf(text.c_str(), "%d,%d,%d,%d%c", &w.column, &w.row, &w.columns, &w.rows, &rest);
    if (read != 4 || w.columns < 1 || w.rows < 1)
        throw base::InputError(
            fmt::format("--window {}: write COLUMN,ROW,WIDTH,HEIGHT in samples, as 64,0,128,128", text));
    return w;
}

std::vector<const land::FieldMethod*> methods_from(const Options& options) {
    std::vector<const land::FieldMethod*> methods;
    for (std::size_t at = 0; at <= options.method.size();) {
        const std::size_t end = std::min(options.method.find(',', at), options.method.size());
        const std::string name = options.method.substr(at, end - at);
        at = end + 1;
        const land::FieldMethod* found = land::field_method(name);
        if (found == nullptr && name != "all") {
            std::vector<std::string_view> names;
            for (const land::FieldMethod& m : land::field_methods()) names.push_back(m.name);
            throw base::InputError(fmt::format("{} is not a method; there are {}", name, fmt::join(names, ", ")));
        }
        for (const land::FieldMethod& m : land::field_methods())
            if (name == "all" || m.name == name) methods.push_back(&m);
    }
    std::vector<std::string_view> takers;
    for (const land::FieldMethod& m : land::field_methods())
        if (m.takes_pictures) takers.push_back(m.name);
    for (const land::FieldMethod* m : methods)
        if (!options.with.empty() && !m->takes_pictures)
            throw base::InputError(fmt::format("--with: {} has no noise that a picture could stand in for; {} have",
                                               m->name, fmt::join(takers, ", ")));
    if (methods.size() > 1 && !options.is_relief)
        throw base::InputError("several methods are drawn side by side with --relief; a field is one method's");
    return methods;
}

// A grey picture as shares of white; says which of its samples are holes or beyond the range.
mesh::Field shares_of(const std::string& file, const std::string& range_text, std::string_view range_option,
                      std::optional<float> nodata) {
    std::optional<pictures::MaskRange> range;
    if (!range_text.empty()) range = pictures::mask_range_from(range_text, range_option);
    pictures::Mask mask = pictures::mask_from(pictures::read_grey_picture(file), file, range, nodata, range_option);
    if (mask.holes > 0)
        std::fprintf(stderr, "%s: %zu of %zu samples are holes; they have what is around them\n", file.c_str(),
                     mask.holes, mask.share.samples.size());
    if (mask.cut > 0)
        std::fprintf(stderr, "%s: %zu samples beyond %s %s were cut\n", file.c_str(), mask.cut,
                     std::string(range_option).c_str(), range_text.c_str());
    return std::move(mask.share);
}

std::shared_ptr<const synthesis::noise::PictureLattice> lattice_for(const Options& options) {
    std::vector<mesh::Field> shares;
    for (const std::string& file : options.with) {
        shares.push_back(shares_of(file, options.with_range, "--with-range", std::nullopt));
        if (shares.back().columns < 2 || shares.back().rows < 2)
            throw base::InputError(fmt::format("{}: a picture of {} by {} samples; 2 by 2 are the least", file,
                                               shares.back().columns, shares.back().rows));
    }
    auto lattice = std::make_shared<const synthesis::noise::PictureLattice>(shares);
    if (lattice->blended() > 0)
        std::fprintf(stderr, "%d of %zu pictures do not repeat: their edges were blended with their middles\n",
                     lattice->blended(), shares.size());
    return lattice;
}

land::FieldRequest request_from(const Options& options) {
    land::FieldRequest request;
    request.size = options.size;
    request.seed = base::Seed{options.seed};
    request.features = options.features > 0 ? options.features : options.with.empty() ? 4.0F : 1.0F;
    request.octaves = options.octaves;
    request.gain = options.gain;
    request.window = window_from(options.window, options.size);
    if (!options.fix_file.empty())
        request.fixed = land::fixed_points_from(base::read_text(options.fix_file), options.fix_file);
    if (!options.line_file.empty())
        request.lines = land::lines_from(base::read_text(options.line_file), options.line_file);
    land::check(request);
    if (!options.with.empty()) request.pictures = lattice_for(options);
    return request;
}

// The method's own field, a band after the other.
mesh::Field in_bands(const land::FieldMethod& method, land::FieldRequest request, const Window& window,
                     Progress& progress) {
    constexpr int kSamplesABand = 1 << 20;
    const int band = std::max(16, kSamplesABand / window.columns);
    mesh::Field field(window.columns, window.rows);
    request.fixed.clear();
    request.lines.clear();
    for (int row = 0; row < window.rows; row += band) {
        request.window = {window.column, window.row + row, window.columns, std::min(band, window.rows - row)};
        const mesh::Field part = method.make(request);
        std::copy(part.samples.begin(), part.samples.end(),
                  field.samples.begin() + static_cast<std::ptrdiff_t>(field.index(0, row)));
        progress.at(static_cast<double>(row + band) / window.rows);
    }
    return field;
}

void condition(mesh::Field& field, const Window& window, const land::Conditions& conditions, Progress& progress) {
    constexpr int kBand = 64;
    for (int row = 0; row < window.rows; row += kBand) {
        const Window of{window.column, window.row + row, window.columns, std::min(kBand, window.rows - row)};
        mesh::Field part(of.columns, of.rows);
        const auto first = field.samples.begin() + static_cast<std::ptrdiff_t>(field.index(0, row));
        std::copy(first, first + static_cast<std::ptrdiff_t>(part.samples.size()), part.samples.begin());
        conditions.apply(part, of);
        std::copy(part.samples.begin(), part.samples.end(), first);
        progress.at(static_cast<double>(row + kBand) / window.rows);
    }
}

void search_toward(mesh::Field& field, const mesh::Field& mask, const Options& options, int reach) {
    const land::DeformationSearch search{options.search, options.search_most, reach};
    Progress progress("searching");
    const land::Bent bent =
        land::bend_to_mask(field, mask, search, base::Seed{options.seed}.child("deformations"),
                           [&](int made) { progress.at(static_cast<double>(made) / options.search_most); });
    std::fprintf(stderr,
                 "%s: cost %.4f, then %.4f after %zu deformations of %d tried, which moved the land by %.4f in the "
                 "mean%s\n",
                 options.mask_file.c_str(), bent.cost_before, bent.cost, bent.deformations.size(), bent.tried,
                 bent.moved, bent.cost > static_cast<double>(options.search) ? "; no better was found" : "");
}

void follow(mesh::Field& field, const Options& options) {
    mesh::Field mask = shares_of(options.mask_file, options.mask_range, "--mask-range", options.mask_nodata);
    for (float& h : mask.samples) h = options.mask_heights[0] + h * (options.mask_heights[1] - options.mask_heights[0]);
    const int reach = options.mask_reach > 0 ? options.mask_reach : std::max(1, options.size / 32);
    if (options.search > 0) return search_toward(field, mask, options, reach);
    const float left = land::follow_mask(field, mask, reach);
    std::fprintf(stderr, "%s: met within %.4f in the mean over %d by %d samples\n", options.mask_file.c_str(),
                 static_cast<double>(left), 2 * reach + 1, 2 * reach + 1);
}

double sum_of(const mesh::Field& field) { return std::accumulate(field.samples.begin(), field.samples.end(), 0.0); }

// Where the earth went, as sums of heights in the field's own unit.
void tell_budget(const land::MovedEarth& moved, double before_m, double after_m, double cell_m2, double unit_m) {
    const auto heights = [&](double m3) { return m3 / cell_m2 / unit_m; };
    std::fprintf(
        stderr,
        "sum of heights %.2f, then %.2f: worn %.2f, laid down again %.2f, carried off the edge %.2f, crept off "
        "it %.2f; %.4f unaccounted for\n",
        before_m / unit_m, after_m / unit_m, heights(moved.worn_m3), heights(moved.laid_m3),
        heights(moved.carried_off_m3), heights(moved.crept_off_m3),
        (before_m - after_m) / unit_m - heights(moved.carried_off_m3 + moved.crept_off_m3));
}

// Erosion thinks in metres: a sample is one, and a height of 1 a ninth of the field's side.
void filter(mesh::Field& field, const Options& options) {
    if (options.burrs > 0) land::remove_burrs(field, options.burrs, 3);
    if (options.smooth > 0) land::smooth(field, options.smooth);
    if (options.erode == 0 && !(options.repose_deg > 0)) return;
    constexpr float kCell_m = 2;
    const float unit_m = kCell_m * static_cast<float>(options.size - 1) / 9;
    for (float& h : field.samples) h *= unit_m;
    Progress progress("eroding");
    land::MovedEarth moved;
    const double before = sum_of(field);
    for (int step = 0; step < options.erode; ++step) {
        const land::MovedEarth now = land::erode_by_streams(field, kCell_m, {.steps = 1, .sea_m = -1.0e9F});
        moved.worn_m3 += now.worn_m3;
        moved.laid_m3 += now.laid_m3;
        moved.carried_off_m3 += now.carried_off_m3;
        moved.crept_off_m3 += now.crept_off_m3;
        progress.at(static_cast<double>(step + 1) / options.erode);
    }
    if (options.erode > 0) tell_budget(moved, before, sum_of(field), kCell_m * kCell_m, unit_m);
    constexpr int kSlides = 400;
    const float slope = std::tan(options.repose_deg * std::numbers::pi_v<float> / 180.0F);
    for (int slides = 0; options.repose_deg > 0 && slides < kSlides; slides += 10) {
        if (land::slide_to_repose(field, kCell_m, slope, 10) <= slope) break;
        progress.at(static_cast<double>(slides) / kSlides);
    }
    for (float& h : field.samples) h /= unit_m;
}

mesh::Field cut_out(const mesh::Field& field, const Window& w) {
    mesh::Field part(w.columns, w.rows);
    for (int y = 0; y < w.rows; ++y)
        for (int x = 0; x < w.columns; ++x) part.at(x, y) = field.at(w.column + x, w.row + y);
    return part;
}

mesh::Field make(const land::FieldMethod& method, const Options& options, const land::FieldRequest& asked) {
    const land::FieldRequest request = land::prepared(method, asked);
    const Window whole{0, 0, options.size, options.size};
    const Window& made = options.needs_the_whole() ? whole : request.window;
    Progress progress(std::string(method.name));
    mesh::Field field = in_bands(method, request, made, progress);
    if (!options.mask_file.empty()) follow(field, options);
    if (!request.fixed.empty() || !request.lines.empty()) {
        land::FieldRequest alone = request;
        alone.fixed.clear();
        alone.lines.clear();
        const land::Conditions conditions(request, [&](int column, int row) {
            if (!options.mask_file.empty()) return field.at(column, row);
            alone.window = {column, row, 1, 1};
            return method.make(alone).at(0, 0);
        });
        Progress meeting("meeting what is known");
        condition(field, made, conditions, meeting);
    }
    if (options.has_filters()) filter(field, options);
    return options.needs_the_whole() ? cut_out(field, request.window) : field;
}

void write(const mesh::Field& field, const Options& options) {
    const float low = options.range[0];
    const float high = options.range[1];
    const bool is_png = base::ending_of(options.output) == ".png";
    const std::string bytes = is_png ? pictures::encoded_heights(options.output, field, low, high)
                                     : pictures::encoded_field(options.output, field);
    obey_interrupts();
    base::write_file(options.output, bytes);
    const auto cut = std::ranges::count_if(field.samples, [&](float h) { return h < low || h > high; });
    if (is_png && cut > 0)
        std::fprintf(stderr, "%s: %td heights beyond %g to %g were cut; --range LOW HIGH sets it\n",
                     options.output.c_str(), cut, static_cast<double>(low), static_cast<double>(high));
}

void draw_side_by_side(const std::vector<const land::FieldMethod*>& methods, const Options& options,
                       const land::FieldRequest& request) {
    constexpr int kSide_px = 480;
    std::vector<pictures::SheetEntry> entries;
    for (const land::FieldMethod* method : methods)
        entries.push_back(
            {pictures::draw_relief(make(*method, options, request), kSide_px, 0.28F), std::string(method->name)});
    const auto columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(entries.size()))));
    obey_interrupts();
    pictures::write_image(options.output, pictures::contact_sheet(entries, columns, kSide_px));
}

void check(const Options& options) {
    if (options.is_relief)
        base::require_ending(options.output, {".png"}, "a relief");
    else
        base::require_ending(options.output, {".exr", ".tif", ".tiff", ".png"}, "a field");
    if (!options.mask_range.empty()) pictures::mask_range_from(options.mask_range, "--mask-range");
    if (!options.with_range.empty()) pictures::mask_range_from(options.with_range, "--with-range");
    if (!(options.range[0] < options.range[1]))
        throw base::InputError("--range: the first height is black and lower than the second, which is white");
    constexpr int kLargestEroded = 4097;
    if (options.erode > 0 && options.size > kLargestEroded)
        throw base::InputError(
            fmt::format("--erode: a field of {} samples a side; to {} can be eroded", options.size, kLargestEroded));
}

int run(const Options& options) {
    check(options);
    const auto methods = methods_from(options);
    const land::FieldRequest request = request_from(options);
    const InterruptsNoted noted;
    try {
        if (options.is_relief)
            draw_side_by_side(methods, options, request);
        else
            write(make(*methods.front(), options, request), options);
    } catch (const Interrupted&) {
        std::fprintf(stderr, "quadrat: interrupted; %s was not written\n", options.output.c_str());
        return 128 + SIGINT;
    }
    return 0;
}

void add_constraints(const Command& command, Options& options) {
    command.add_option("--fix", options.fix_file, "Known heights: a file of lines, column row height")
        .tells_default("none");
    command
        .add_option("--lines", options.line_file,
                    "Known crests and beds: a file of lines, ridge|river and three numbers a corner")
        .tells_default("none");
    const Option mask =
        command.add_option("--mask", options.mask_file, "A grey picture whose broad course the field follows")
            .tells_default("none");
    command
        .add_option("--mask-range", options.mask_range,
                    "LOW:HIGH, which of its own numbers are its black and white: metres of an elevation model, say")
        .tells_default("0:1 of floats, all of whole numbers")
        .needs(mask);
    command
        .add_option("--mask-nodata", options.mask_nodata,
                    "A number that stands for a hole, besides -9999 and its like; a GeoTIFF may say it itself")
        .tells_default("none")
        .needs(mask);
    command.add_option("--mask-heights", options.mask_heights, "Heights of its black and its white")
        .takes(2)
        .shows_default();
    command.add_option("--mask-reach", options.mask_reach, "How broad that is, samples; 0: a 32nd of the size")
        .between(0, 1024)
        .shows_default();
    command
        .add_option("--search", options.search,
                    "Bend it to the mask by a search over deformations instead, until this is left in the mean square")
        .between(0.0F, 10.0F)
        .tells_default("0: it follows the mask all over")
        .needs(mask);
    command.add_option("--search-most", options.search_most, "Deformations that the search may make")
        .between(1, 10000)
        .shows_default();
}

void add_pictures(const Command& command, Options& options) {
    const Option with = command
                            .add_option("--with", options.with,
                                        "A grey picture in place of noise; the next one is for the next octave, the "
                                        "last for all that are left")
                            .takes_one_each_time()
                            .tells_default("none: noise");
    command
        .add_option("--with-range", options.with_range,
                    "LOW:HIGH, which of the pictures' own numbers are their black, a height of -1, and white, 1")
        .tells_default("0:1 of floats, all of whole numbers")
        .needs(with);
}

void add_filters(const Command& command, Options& options) {
    command
        .add_option("--burrs", options.burrs,
                    "Take off burrs, wrinkles and pits that stand out from the slopes around them by more than this")
        .between(0.0F, 10.0F)
        .shows_default();
    command.add_option("--smooth", options.smooth, "Mean over this many samples to each side")
        .between(0, 256)
        .shows_default();
    command.add_option("--erode", options.erode, "Steps of erosion by streams").between(0, 200).shows_default();
    command.add_option("--repose", options.repose_deg, "Let slopes slide to this angle, degrees")
        .between(0.0F, 80.0F)
        .tells_default("0: none slides");
}

}  // namespace

void add_field(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("field", "Write one heightfield, by any of the methods");
    command.add_option("method", options->method, "fbm, diamond-square, island …; an unknown one lists them all")
        .required();
    command.add_option("-o,--output", options->output, "NAME.exr or NAME.tif, 32-bit floats; NAME.png, 16-bit")
        .required();
    command.add_option("--size", options->size, "Samples a side, 2 to 8193").shows_default();
    command.add_option("--seed", options->seed, "Of chance").shows_default();
    command
        .add_option("--features", options->features,
                    "Waves of the first octave across the field; of pictures, how often the first is laid out")
        .tells_default("4; of pictures 1");
    command.add_option("--octaves", options->octaves, "1 to 16").shows_default();
    command.add_option("--gain", options->gain, "Of each octave to the one before; H = -log2 of it").shows_default();
    command.add_option("--window", options->window, "COLUMN,ROW,WIDTH,HEIGHT: this part alone, the same to the bit")
        .tells_default("all of it");
    command.add_option("--range", options->range, "Heights that are black and white in a PNG").takes(2).shows_default();
    command.add_flag("--relief", options->is_relief,
                     "Draw it instead, as a lit block; several methods, or all, side by side");
    add_constraints(command, *options);
    add_pictures(command, *options);
    add_filters(command, *options);
    command.does([options] { return run(*options); });
}

}  // namespace quadrat::commands
