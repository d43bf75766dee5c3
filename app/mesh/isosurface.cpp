// SPDX-License-Identifier: Apache-2.0
// A dual method: a vertex for each sheet of the surface within a cell, a quadrilateral for each lattice edge that
// crosses it (Gibson's surface nets, 1998; a vertex a sheet as in Nielson, "Dual marching cubes", 2004). Two sheets can
// meet twice over one face; a vertex more on each of the two meetings keeps the surface a 2-manifold (cf. Wenger,
// "Isosurfaces", 2013, chapter 4).
#include "mesh/isosurface.hpp"

#include <algorithm>
#include <cstring>
#include <map>

#include "mesh/cell_sheets.hpp"

namespace quadrat::mesh {
namespace {

constexpr int kSide = SparseField::kSide;
constexpr std::uint32_t kNone = 0xFFFFFFFFU;

// A block and the seven after it: samples and signs across its far faces.
struct Neighbourhood {
    std::array<const SparseField::Block*, 8> blocks;  // null: outside
    std::array<const std::array<std::uint8_t, 64>*, 8> signs;
    float at(int x, int y, int z) const {
        const int part = (x >> 3) | ((y >> 3) << 1) | ((z >> 3) << 2);
        const SparseField::Block* block = blocks[part];
        return block == nullptr ? -1.0F : (*block)[((z & 7) * kSide + (y & 7)) * kSide + (x & 7)];
    }
    // Bits of the nine samples of a row.
    std::uint32_t row(int y, int z) const {
        const int part = ((y >> 3) << 1) | ((z >> 3) << 2);
        const int i = (z & 7) * kSide + (y & 7);
        const std::uint32_t near = signs[part] == nullptr ? 0U : (*signs[part])[i];
        const std::uint32_t far = signs[part | 1] == nullptr ? 0U : (*signs[part | 1])[i] & 1U;
        return near | (far << 8);
    }
};

class Polygoniser {
  public:
    explicit Polygoniser(const SparseField& field)
        : field_(field),
          table_(sheet_table()),
          signs_(field.count()),
          has_inside_(field.count()),
          is_crossed_(field.count()),
          cells_(std::make_unique_for_overwrite<Cells[]>(std::max<std::size_t>(field.count(), 1))) {
        for (std::size_t b = 0; b < field.count(); ++b) read_signs(b);
    }

    Surface run() {
        surface_.positions.reserve(24 * field_.count());
        surface_.blocks.reserve(24 * field_.count());
        for (std::size_t b = 0; b < field_.count(); ++b) place_vertices(b);
        surface_.indices.reserve(6 * surface_.positions.size() + surface_.positions.size() / 4 + 64);
        for (std::size_t b = 0; b < field_.count(); ++b) join_vertices(b);
        return std::move(surface_);
    }

  private:
    struct Cells {
        std::uint32_t base;                                      // the block's first vertex
        std::array<std::uint16_t, SparseField::kSamples> first;  // and from it, that of the cell's first sheet
        std::array<std::uint8_t, SparseField::kSamples> inside;
    };
    struct Ref {
        std::uint32_t first;
        std::uint8_t inside;
    };

    void read_signs(std::size_t b) {
        const SparseField::Block& values = field_.block(b);
        std::uint32_t any = 0;
        for (int row = 0; row < 64; ++row) {
            std::uint32_t bits = 0;
            for (int x = 0; x < kSide; ++x) bits |= static_cast<std::uint32_t>(values[row * kSide + x] > 0) << x;
            signs_[b][row] = static_cast<std::uint8_t>(bits);
            any |= bits;
        }
        has_inside_[b] = any != 0;
    }

    // False where nothing can cross.
    bool look_around(std::size_t b, Neighbourhood& n) const {
        bool is_inside = false;
        for (int part = 0; part < 8; ++part) {
            const int other = field_.find(field_.place(b) + glm::ivec3{part & 1, (part >> 1) & 1, part >> 2});
            n.blocks[part] = other < 0 ? nullptr : &field_.block(other);
            n.signs[part] = other < 0 ? nullptr : &signs_[other];
            is_inside = is_inside || (other >= 0 && has_inside_[other]);
        }
        return is_inside;
    }

    void place_vertices(std::size_t b) {
        Neighbourhood n;
        if (!look_around(b, n)) return;
        const auto before = static_cast<std::uint32_t>(surface_.positions.size());
        constexpr int kWide = kSide + 1;
        std::array<std::uint32_t, kWide * kWide> rows{};
        for (int z = 0; z <= kSide; ++z)
            for (int y = 0; y <= kSide; ++y) rows[z * kWide + y] = n.row(y, z);
        const bool is_whole = std::ranges::all_of(rows, [](std::uint32_t row) { return row == 0x1FF; });
        if (is_whole || std::ranges::all_of(rows, [](std::uint32_t row) { return row == 0; })) return;
        Cells& cells = cells_[b];
        cells.base = before;
        cells.inside.fill(0);
        is_crossed_[b] = 1;
        const glm::vec3 origin = glm::vec3(field_.place(b) * kSide);
        for (int z = 0; z < kSide; ++z) {
            for (int y = 0; y < kSide; ++y) {
                const std::uint32_t* row = &rows[z * kWide + y];
                const std::uint32_t r[4] = {row[0], row[1], row[kWide], row[kWide + 1]};
                const std::uint32_t some = r[0] | r[1] | r[2] | r[3];
                const std::uint32_t all = r[0] & r[1] & r[2] & r[3];
                if (some == 0 || all == 0x1FF) continue;
                for (int x = 0; x < kSide; ++x) {
                    std::uint32_t inside = 0;
                    for (int k = 0; k < 4; ++k) inside |= ((r[k] >> x) & 3U) << (2 * k);
                    if (inside == 0 || inside == 255) continue;
                    const int cell = (z * kSide + y) * kSide + x;
                    cells.inside[cell] = static_cast<std::uint8_t>(inside);
                    cells.first[cell] = static_cast<std::uint16_t>(surface_.positions.size() - before);
                    add_sheets(n, {x, y, z}, inside, origin, static_cast<std::uint32_t>(b));
                }
            }
        }
    }

    void add_sheets(const Neighbourhood& n, glm::ivec3 cell, std::uint32_t inside, const glm::vec3& origin,
                    std::uint32_t b) {
        const Sheets& sheets = table_[inside];
        std::array<float, 8> corner;
        const SparseField::Block* own =
            cell.x < kSide - 1 && cell.y < kSide - 1 && cell.z < kSide - 1 ? n.blocks[0] : nullptr;
        const int first = (cell.z * kSide + cell.y) * kSide + cell.x;
        for (int c = 0; c < 8; ++c) {
            if (own != nullptr)
                corner[c] = (*own)[first + (c & 1) + ((c >> 1) & 1) * kSide + (c >> 2) * kSide * kSide];
            else
                corner[c] = n.at(cell.x + (c & 1), cell.y + ((c >> 1) & 1), cell.z + (c >> 2));
        }
        const auto crossing = [&](int e) {
            const int axis = e >> 2;
            const int low = kLow[e];
            const float a = corner[low];
            const float c = corner[low | (1 << axis)];
            glm::vec3 at{low & 1, (low >> 1) & 1, low >> 2};
            // Away from the corners, so that no two vertices fall together.
            at[axis] = std::clamp(a / (a - c), 0.05F, 0.95F);
            return at;
        };
        if (sheets.count == 1) {  // as nearly always
            glm::vec3 sum{0};
            for (int i = 0; i < sheets.crossings; ++i) sum += crossing(sheets.crossed[i]);
            surface_.positions.push_back(origin + glm::vec3(cell) + sum / static_cast<float>(sheets.crossings));
            surface_.blocks.push_back(b);
            return;
        }
        std::array<glm::vec3, 4> sums{};
        std::array<float, 4> counts{};
        for (int i = 0; i < sheets.crossings; ++i) {
            const int e = sheets.crossed[i];
            const int sheet{sheets.of_edge[e]};
            sums[sheet] += crossing(e);
            counts[sheet] += 1;
        }
        for (int s = 0; s < sheets.count; ++s) {
            surface_.positions.push_back(origin + glm::vec3(cell) + sums[s] / counts[s]);
            surface_.blocks.push_back(b);
        }
    }

    Ref cell_at(glm::ivec3 cell, std::size_t home) const {
        const glm::ivec3 place{cell.x >> 3, cell.y >> 3, cell.z >> 3};
        const int b = place == field_.place(home) ? static_cast<int>(home) : field_.find(place);
        if (b < 0 || is_crossed_[b] == 0) return {kNone, 0};
        const int i = ((cell.z & 7) * kSide + (cell.y & 7)) * kSide + (cell.x & 7);
        return {cells_[b].base + cells_[b].first[i], cells_[b].inside[i]};
    }

    // Whether none of a row's eight cells is crossed.
    static bool is_idle(const Cells& cells, int first) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, &cells.inside[first], sizeof eight);
        return eight == 0;
    }

    // The lattice edges that begin at this block's samples.
    void join_vertices(std::size_t b) {
        if (is_crossed_[b] == 0) return;
        const Cells& cells = cells_[b];
        const glm::ivec3 origin = field_.place(b) * kSide;
        for (int i = 0; i < SparseField::kSamples; ++i) {
            if (i % 8 == 0 && is_idle(cells, i)) {
                i += 7;
                continue;
            }
            const std::uint8_t inside = cells.inside[i];
            if (inside == 0) continue;  // no edge of this cell crosses
            const glm::ivec3 in_block{i % kSide, i / kSide % kSide, i / (kSide * kSide)};
            const bool is_in = (inside & 1) != 0;
            for (int axis = 0; axis < 3; ++axis) {
                const bool is_next_in = ((inside >> (1 << axis)) & 1) != 0;
                if (is_in == is_next_in) continue;
                const bool is_within = in_block[(axis + 1) % 3] > 0 && in_block[(axis + 2) % 3] > 0;
                if (!is_within || !add_face_within(cells, i, axis, is_in)) add_face(origin + in_block, axis, is_in, b);
            }
        }
    }

    // Where all four cells about the edge lie in one block and nothing is pinched, as nearly always; false: not here.
    bool add_face_within(const Cells& cells, int i, int axis, bool is_outward) {
        constexpr std::array<int, 3> kStride{1, kSide, kSide * kSide};
        const int b = kStride[(axis + 1) % 3];
        const int c = kStride[(axis + 2) % 3];
        const std::array<int, 4> cell{i, i - b, i - b - c, i - c};
        constexpr std::array<int, 4> kPlace{0, 1, 3, 2};
        std::array<std::uint32_t, 4> ring;
        int pinched = 0;
        for (int j = 0; j < 4; ++j) {
            const Sheets& sheets = table_[cells.inside[cell[j]]];
            pinched |= sheets.pinched;
            const int sheet{sheets.of_edge[4 * axis + kPlace[j]]};
            ring[j] = cells.base + cells.first[cell[j]] + static_cast<std::uint32_t>(sheet);
        }
        if (pinched != 0) return false;
        emit_pair(ring, is_outward);
        return true;
    }

    void add_face(glm::ivec3 at, int axis, bool is_outward, std::size_t block) {
        const int b = (axis + 1) % 3;
        const int c = (axis + 2) % 3;
        // The four cells about the edge, in order; in cell j the edge has the place kPlace[j].
        constexpr std::array<std::array<int, 2>, 4> kShift{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
        constexpr std::array<int, 4> kPlace{0, 1, 3, 2};
        std::array<glm::ivec3, 4> cell;
        std::array<Ref, 4> ref;
        std::array<std::uint32_t, 4> vertex;
        for (int j = 0; j < 4; ++j) {
            cell[j] = at;
            cell[j][b] += kShift[j][0];
            cell[j][c] += kShift[j][1];
            ref[j] = cell_at(cell[j], block);
            if (ref[j].first == kNone || ref[j].inside == 0) return;  // the field was cut off here
            vertex[j] = ref[j].first + static_cast<std::uint32_t>(table_[ref[j].inside].of_edge[4 * axis + kPlace[j]]);
        }
        const int pinched = table_[ref[0].inside].pinched | table_[ref[1].inside].pinched |
                            table_[ref[2].inside].pinched | table_[ref[3].inside].pinched;
        if (pinched == 0) return emit_pair(vertex, is_outward);
        std::array<std::uint32_t, 8> ring{};
        std::size_t count = 0;
        std::size_t hub = 8;
        for (int j = 0; j < 4; ++j) {
            const int next = (j + 1) % 4;
            ring[count++] = vertex[j];
            // Consecutive cells differ along b for j even, along c for j odd.
            const int normal = j % 2 == 0 ? b : c;
            const std::uint32_t middle =
                meeting(cell[j], ref[j], cell[next], ref[next], normal, axis, at, vertex[j], vertex[next]);
            if (middle == kNone) continue;
            hub = count;
            ring[count++] = middle;
        }
        if (hub < count) return emit_fan(ring, count, hub, is_outward);
        emit_pair(vertex, is_outward);
    }

    // The vertex between two sheets that meet twice over one face; none when they meet once.
    std::uint32_t meeting(glm::ivec3 cell_a, const Ref& a, glm::ivec3 cell_b, const Ref& b, int normal, int axis,
                          glm::ivec3 edge, std::uint32_t vertex_a, std::uint32_t vertex_b) {
        const bool is_a_low = cell_a[normal] < cell_b[normal];
        const int a_face = 1 << (2 * normal + (is_a_low ? 1 : 0));
        const int b_face = 1 << (2 * normal + (is_a_low ? 0 : 1));
        if ((table_[a.inside].pinched & a_face) == 0 || (table_[b.inside].pinched & b_face) == 0) return kNone;
        // Named by the face and by the inside corner that the segment cuts off, which is the edge's own inside end.
        const glm::ivec3 low_cell = is_a_low ? cell_a : cell_b;
        glm::ivec3 corner = edge;
        glm::ivec3 other = edge;
        other[axis] += 1;
        if (field_.at(edge) <= 0) corner = other;
        const std::array<int, 7> key{low_cell.x, low_cell.y, low_cell.z, normal, corner.x, corner.y, corner.z};
        const auto [found, is_new] = meetings_.try_emplace(key, static_cast<std::uint32_t>(surface_.positions.size()));
        if (is_new) {
            const glm::vec3 between = 0.5F * (surface_.positions[vertex_a] + surface_.positions[vertex_b]);
            surface_.positions.push_back(between + 0.25F * (glm::vec3(corner) - between));
            surface_.blocks.push_back(surface_.blocks[vertex_a]);
        }
        return found->second;
    }

    void add_triangle(std::uint32_t p, std::uint32_t q, std::uint32_t r, bool is_outward) {
        if (!is_outward) std::swap(q, r);
        surface_.indices.insert(surface_.indices.end(), {p, q, r});
    }

    // Only the added vertex may have diagonals.
    void emit_fan(const std::array<std::uint32_t, 8>& ring, std::size_t count, std::size_t hub, bool is_outward) {
        for (std::size_t k = 1; k + 1 < count; ++k)
            add_triangle(ring[hub], ring[(hub + k) % count], ring[(hub + k + 1) % count], is_outward);
    }

    // The shorter diagonal makes the better pair.
    void emit_pair(const std::array<std::uint32_t, 4>& ring, bool is_outward) {
        const auto& p = surface_.positions;
        const glm::vec3 d02 = p[ring[2]] - p[ring[0]];
        const glm::vec3 d13 = p[ring[3]] - p[ring[1]];
        const std::size_t turn =
            d02.x * d02.x + d02.y * d02.y + d02.z * d02.z <= d13.x * d13.x + d13.y * d13.y + d13.z * d13.z ? 0 : 1;
        const std::uint32_t a = ring[turn];
        std::uint32_t b = ring[turn + 1];
        const std::uint32_t c = ring[turn + 2];
        std::uint32_t d = ring[(turn + 3) % 4];
        if (!is_outward) std::swap(b, d);
        surface_.indices.insert(surface_.indices.end(), {a, b, c, a, c, d});
    }

    const SparseField& field_;
    const std::array<Sheets, 256>& table_;
    std::vector<std::array<std::uint8_t, 64>> signs_;
    std::vector<char> has_inside_;
    std::vector<char> is_crossed_;  // a block: its cells are filled in
    std::unique_ptr<Cells[]> cells_;
    std::map<std::array<int, 7>, std::uint32_t> meetings_;
    Surface surface_;
};

}  // namespace

Surface polygonise(const SparseField& field) { return Polygoniser(field).run(); }

}  // namespace quadrat::mesh
