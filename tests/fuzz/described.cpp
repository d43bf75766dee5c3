// SPDX-License-Identifier: Apache-2.0
// Files of described scenes, and maps of them: what is read comes back from its own text, and trains a map whose
// answers are finite.
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "breeding/words/lessons.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat;
    try {
        const std::string_view text(reinterpret_cast<const char*>(bytes), size);
        const breeding::Lessons lessons = breeding::word_lessons_from(text, "input");
        if (breeding::word_lessons_from(breeding::to_json(lessons), "again") != lessons) std::abort();
        const auto& scenes = lessons.curator;
        breeding::remarks_on(scenes);
        if (scenes.empty() || scenes.size() > 40) return 0;
        const breeding::WordMap map(scenes);
        const genome::ParameterValues values = map(map.completed(scenes.front().words));
        for (const genome::Parameter& p : genome::parameter_table())
            if (!(values[p.id] >= p.min && values[p.id] <= p.max)) std::abort();
    } catch (const base::InputError&) {
    }
    return 0;
}
