// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

namespace quadrat::render::gl {

// The way to the GPU in two parts: what is worked out without one, on any thread, and then pieces that each move about
// as many bytes as they say.
class Slices {
  public:
    // Needs no GPU; done in the order they are added, before every piece.
    void prepare(std::function<void()> work) { to_prepare_.push_back(std::move(work)); }

    // Once, on any one thread, before the first advance().
    void prepare_all() {
        for (const auto& work : std::exchange(to_prepare_, {})) work();
    }

    void add(std::size_t bytes, std::function<void()> work) { waiting_.push_back({bytes, std::move(work)}); }

    // [0, count) in pieces of at most `piece` elements: work(first, how_many).
    template <typename Work>
    void add_pieces(std::size_t count, std::size_t piece, std::size_t bytes_each, Work work) {
        for (std::size_t first = 0; first < count; first += piece) {
            const std::size_t many = count - first < piece ? count - first : piece;
            add(many * bytes_each, [work, first, many] { work(first, many); });
        }
    }

    // Does pieces, at least one, until budget_bytes are spent or has_time() says no; true when none are left.
    bool advance(std::size_t budget_bytes, const std::function<bool()>& has_time = {}) {
        prepare_all();
        std::size_t spent = 0;
        while (!waiting_.empty() &&
               (spent == 0 || (spent + waiting_.front().bytes <= budget_bytes && (!has_time || has_time())))) {
            Slice next = std::move(waiting_.front());
            waiting_.pop_front();
            next.work();
            spent += next.bytes + 1;
        }
        return waiting_.empty();
    }

  private:
    struct Slice {
        std::size_t bytes;
        std::function<void()> work;
    };
    std::vector<std::function<void()>> to_prepare_;
    std::deque<Slice> waiting_;
};

}  // namespace quadrat::render::gl
