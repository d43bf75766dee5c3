// SPDX-License-Identifier: Apache-2.0
#include "desk/curator_answers.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "desk/curator_pages.hpp"
#include "desk/desk.hpp"

namespace quadrat::desk {
namespace {

constexpr std::string_view kCurator = "/curator";
constexpr std::string_view kLandscape = "/curator/landscape/", kPostcard = "/curator/postcard/", kPng = ".png";
constexpr std::size_t kPrefix = kCurator.size() + 1;

std::string value_in(const Fields& fields, const std::string& name) {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string{} : found->second;
}

Answer html(std::string page, int status = 200) { return {status, "text/html; charset=utf-8", std::move(page), {}}; }

Answer redirected(const std::string& to) {
    return {303, "text/plain; charset=utf-8", "See " + to + "\n", {{"Location", to}}};
}

// As it may stand in a query.
std::string in_query(const std::string& text) {
    std::string query;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_plain = (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z') ||
                              (byte >= 'A' && byte <= 'Z') || byte == '-' || byte == '.';
        query += is_plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return query;
}

Answer no_page(const View& view) {
    return html(trouble_page({view.sources, view.say, "/", "", ""}, "trouble.page", ""), 404);
}

}  // namespace

bool is_curators(std::string_view path) {
    return path == kCurator || (path.starts_with(kCurator) && path[kCurator.size()] == '/');
}

Answer curated(const Request& request, View view) {
    const std::string done = value_in(request.form, "done");
    if (done == "saved" || done == "same") view.done = view.say("curator." + done);
    if (done == "undone") {
        const std::string& part = view.say("curator." + value_in(request.form, "what"));
        view.done = view.say("curator.undone", {part});
    }
    if (request.path == "/curator") return html(curator_page(view));
    const auto id_after = [&](std::string_view folder) -> std::optional<std::string> {
        if (!request.path.starts_with(folder) || !request.path.ends_with(kPng)) return std::nullopt;
        return request.path.substr(folder.size(), request.path.size() - folder.size() - kPng.size());
    };
    if (const auto id = id_after(kLandscape)) {
        auto picture = view.sources.curator.landscape(*id);
        return picture ? Answer{200, "image/png", std::move(*picture), {}} : no_page(view);
    }
    if (const auto id = id_after(kPostcard)) {
        auto card = view.sources.curator.postcard(*id);
        if (!card) return no_page(view);  // else its name is what was asked for: digits alone
        const std::string kept_as = fmt::format("attachment; filename=\"quadrat-{}.png\"", *id);
        return {200, "image/png", std::move(*card), {{"Content-Disposition", kept_as}}};
    }
    const auto form = view.sources.curator.form(request.path.substr(kPrefix), request.form, view.say);
    return form ? html(form_page(view, *form, {})) : no_page(view);
}

Answer curate(const Request& request, const View& view) {
    const Sources& sources = view.sources;
    if (request.path == "/curator") {
        const auto taken_back = sources.curator.undo(request.peer);
        if (!taken_back) return redirected("/curator?done=same");
        sources.note(fmt::format("{} took back the last change of {}", request.peer, *taken_back));
        return redirected("/curator?done=undone&what=" + in_query(*taken_back));
    }
    const bool is_preview = request.path == "/curator/preview";
    const std::string part = is_preview ? value_in(request.form, "part") : request.path.substr(kPrefix);
    const auto form = sources.curator.form(part, request.form, view.say);
    if (!form) return no_page(view);
    const View of_part{sources, view.say, "/curator/" + part, view.form_token, ""};
    try {
        if (is_preview) {
            const std::string entry = value_in(request.form, "preview");
            sources.curator.ask_preview(request.form, entry);
            return html(form_page(of_part, *form, {&request.form, "", entry}));
        }
        const bool removes = request.form.contains("remove");
        const bool is_other = sources.curator.save(part, request.form,
                                                   removes ? Curator::Deed::Remove : Curator::Deed::Save, request.peer);
        if (is_other) sources.note(fmt::format("{} changed {}", request.peer, part));
        std::string query = is_other ? "?done=saved" : "?done=same";
        for (const auto& [name, value] : form->kept)
            if (name != "part" && !removes) query += fmt::format("&{}={}", in_query(name), in_query(value));
        return redirected("/curator/" + (part == "theme" ? "themes" : part) + query);
    } catch (const base::InputError& error) {
        return html(form_page(of_part, *form, {&request.form, error.what(), ""}), 422);
    }
}

}  // namespace quadrat::desk
