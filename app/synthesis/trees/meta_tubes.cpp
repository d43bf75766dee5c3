// SPDX-License-Identifier: Apache-2.0
// Field: Wyvill, McPheeters & Wyvill, "Data structure for soft objects", 1986: (1 - s^2)^3 of the distance s from a
// limb's axis, here in units of its reach. Along one limb the largest counts, so that its internodes do not swell where
// they meet; those of different limbs are added, so that forks are rounded.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "mesh/isosurface.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/meta_field_kernel.hpp"
#include "synthesis/trees/meta_surface_kernel.hpp"
#include "synthesis/trees/tube_frames.hpp"

namespace quadrat::synthesis::trees {
namespace {

using mesh::SparseField;

constexpr float kSurface = 0.5F;
// Where (1 - s^2)^3 is one half: a limb alone has its own radius.
constexpr float kReach = 2.2016F;
constexpr float kThinnest = 0.9F;  // cells: thinner tubes would fall apart between samples
constexpr float kCut = 0.5F;       // cells: where a tapering limb leaves the field
constexpr int kSide = SparseField::kSide;

using kernel::Piece;

// Which pieces may be felt in a block, by limb.
struct Lists {
    std::vector<std::uint32_t> first;  // a block, and one past the last
    std::vector<std::uint32_t> pieces;
};

glm::vec3 from_of(const Piece& p) { return {p.is[Piece::FromX], p.is[Piece::FromY], p.is[Piece::FromZ]}; }
glm::vec3 along_of(const Piece& p) { return {p.is[Piece::AlongX], p.is[Piece::AlongY], p.is[Piece::AlongZ]}; }

class MetaTubes {
  public:
    MetaTubes(const TreeSkeleton& skeleton, const MetaTubeDetail& detail) : skeleton_(skeleton), detail_(detail) {
        std::vector<std::uint32_t> limbs(skeleton.limbs.size());
        std::iota(limbs.begin(), limbs.end(), 0U);
        if (detail.most_nodes != static_cast<std::size_t>(-1)) limbs = strongest_limbs(skeleton, detail.most_nodes);
        twigs_.longest_path_m = skeleton.longest_path_m;
        glm::vec3 low{1.0e6F};
        glm::vec3 high{-1.0e6F};
        for (const Limb& limb : skeleton.limbs) {
            for (const Limb::Node& node : limb.nodes) {
                low = glm::min(low, node.at_m);
                high = glm::max(high, node.at_m);
            }
        }
        // A block to spare on every side; a trunk's foot is wider and lower than its first node.
        const float margin_m =
            detail.cell_m * (2 * kSide) + (1.6F * kReach + 1) * std::max(thickest_m(skeleton), detail.cell_m);
        origin_m_ = low - margin_m;
        const glm::vec3 cells = (high - low + 2.0F * margin_m) / detail.cell_m;
        field_.emplace(glm::ivec3(cells / static_cast<float>(kSide)) + 1);
        for (const std::uint32_t i : limbs) add_limb(skeleton.limbs[i]);
    }

    scene::Wood mesh() {
        list_pieces();
        for (std::size_t b = 0; b < field_->count(); ++b) fill(b);
        mesh::Surface surface = mesh::polygonise(*field_);
        scene::Wood wood;
        finish(surface, wood);
        wood.mesh.indices = std::move(surface.indices);
        if (!twigs_.limbs.empty()) append_twigs(wood);
        return wood;
    }

  private:
    static float thickest_m(const TreeSkeleton& skeleton) {
        float most = 0;
        for (const Limb& limb : skeleton.limbs) most = std::max(most, limb.nodes.front().radius_m);
        return most;
    }

    void add_limb(const Limb& limb) {
        if (limb.nodes.size() < 2) return;
        const std::vector<Limb::Node> nodes = limb.parent < 0 && detail_.has_foot ? with_foot(limb) : limb.nodes;
        std::size_t count = nodes.size();
        if (detail_.sweeps_twigs) {
            if (limb.parent >= 0 && nodes.front().radius_m < kThinnest * detail_.cell_m) {
                keep_as_twig(nodes, 0);
                return;
            }
            count = 1;
            while (count < nodes.size() && nodes[count].radius_m >= kCut * detail_.cell_m) ++count;
            if (count < nodes.size()) keep_as_twig(nodes, count - 1);
            if (count < 2) return;
        }
        TubeFrame frame = frame_along(direction_at(nodes, 0));
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const glm::vec3 step = nodes[i + 1].at_m - nodes[i].at_m;
            const float length_m = glm::length(step);
            if (length_m < 1.0e-5F) continue;
            frame = transported(frame, step / length_m);
            add_piece(nodes[i], nodes[i + 1], frame);
        }
        ++limb_;
    }

    void keep_as_twig(const std::vector<Limb::Node>& nodes, std::size_t first) {
        if (nodes.size() - first < 2) return;
        Limb twig;
        twig.parent = 0;
        twig.nodes.assign(nodes.begin() + static_cast<std::ptrdiff_t>(first), nodes.end());
        twigs_.limbs.push_back(std::move(twig));
    }

    void add_piece(const Limb::Node& a, const Limb::Node& b, const TubeFrame& frame) {
        const float least_m = kThinnest * detail_.cell_m;
        const float ra = std::max(a.radius_m, least_m);
        const float rb = std::max(b.radius_m, least_m);
        const glm::vec3 from = (a.at_m - origin_m_) / detail_.cell_m;
        const glm::vec3 along = (b.at_m - a.at_m) / detail_.cell_m;
        const float per_reach = detail_.cell_m / (kReach * ra);
        const Piece piece{{from.x,
                           from.y,
                           from.z,
                           along.x,
                           along.y,
                           along.z,
                           1 / std::max(glm::dot(along, along), 1.0e-9F),
                           per_reach,
                           detail_.cell_m / (kReach * rb) - per_reach,
                           a.path_m,
                           b.path_m - a.path_m,
                           a.sway,
                           b.sway - a.sway,
                           frame.side.x,
                           frame.side.y,
                           frame.side.z,
                           frame.up.x,
                           frame.up.y,
                           frame.up.z,
                           frame.along.x,
                           frame.along.y,
                           frame.along.z},
                          kReach * std::max(ra, rb) / detail_.cell_m,
                          limb_};
        pieces_.push_back(piece);
    }

    // Blocks are made in the order of the pieces; each lists its pieces in that order too.
    void list_pieces() {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> felt;
        felt.reserve(16 * pieces_.size());
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            const Piece& p = pieces_[i];
            const glm::vec3 from = from_of(p);
            const glm::vec3 along = along_of(p);
            const glm::vec3 to = from + along;
            const float r = p.reach;
            const auto block_of = [](const glm::vec3& v) {
                return glm::ivec3(glm::floor(v / static_cast<float>(kSide)));
            };
            const glm::ivec3 low = block_of(glm::min(from, to) - r - 1.0F);
            const glm::ivec3 high = block_of(glm::max(from, to) + r + 1.0F);
            // Half the diagonal of a block and a sample around it.
            const float near = r + 0.8661F * (kSide + 2);
            for (int z = low.z; z <= high.z; ++z) {
                for (int y = low.y; y <= high.y; ++y) {
                    for (int x = low.x; x <= high.x; ++x) {
                        const glm::vec3 middle = (glm::vec3{x, y, z} + 0.5F) * static_cast<float>(kSide) - 0.5F;
                        const glm::vec3 d = middle - from;
                        const float t = std::clamp(glm::dot(d, along) * p.is[Piece::PerLength2], 0.0F, 1.0F);
                        const glm::vec3 off = d - t * along;
                        if (glm::dot(off, off) > near * near) continue;
                        const int block = field_->make({x, y, z});
                        if (block >= 0) felt.emplace_back(static_cast<std::uint32_t>(block), i);
                    }
                }
            }
        }
        lists_.first.assign(field_->count() + 1, 0);
        for (const auto& [block, piece] : felt) ++lists_.first[block + 1];
        std::partial_sum(lists_.first.begin(), lists_.first.end(), lists_.first.begin());
        lists_.pieces.resize(felt.size());
        std::vector<std::uint32_t> next(lists_.first.begin(), lists_.first.end() - 1);
        for (const auto& [block, piece] : felt) lists_.pieces[next[block]++] = piece;
    }

    // Sum over limbs of the strongest piece's field, less the surface's.
    void fill(std::size_t b) {
        SparseField::Block& sum = field_->block(b);
        sum.fill(-kSurface);
        SparseField::Block best;
        best.fill(1.0F);
        const glm::vec3 origin = glm::vec3(field_->place(b) * kSide);
        std::uint32_t limb = pieces_[lists_.pieces[lists_.first[b]]].limb;
        for (std::uint32_t k = lists_.first[b]; k < lists_.first[b + 1]; ++k) {
            const Piece& piece = pieces_[lists_.pieces[k]];
            if (piece.limb != limb) add_limb_field(best.data(), sum.data());
            limb = piece.limb;
            feel_in_block(piece, origin, best.data());
        }
        add_limb_field(best.data(), sum.data());
    }

    static bool has_avx2() {
#if defined(__x86_64__)
        static const bool has = __builtin_cpu_supports("avx2") != 0;
        return has;
#else
        return false;
#endif
    }

    static void add_limb_field(float* best, float* sum) {
#if defined(__x86_64__)
        if (has_avx2()) return kernel::add_avx2(best, sum);
#endif
        kernel::FieldKernel<xsimd::default_arch>::add(best, sum);
    }

    static void feel_in_block(const Piece& piece, const glm::vec3& origin, float* best) {
        const glm::vec3 a = from_of(piece) - origin;
        const glm::vec3 along = along_of(piece);
        const glm::vec3 to = a + along;
        const float r = piece.reach;
        const auto first = [r](float p, float q) {
            return std::max(static_cast<int>(std::ceil(std::min(p, q) - r)), 0);
        };
        const auto last = [r](float p, float q) {
            return std::min(static_cast<int>(std::floor(std::max(p, q) + r)), kSide - 1);
        };
        const kernel::Tube tube{a.x,
                                a.y,
                                a.z,
                                along.x,
                                along.y,
                                along.z,
                                piece.is[Piece::PerLength2],
                                piece.is[Piece::PerReach],
                                piece.is[Piece::PerReachMore],
                                first(a.y, to.y),
                                last(a.y, to.y),
                                first(a.z, to.z),
                                last(a.z, to.z)};
#if defined(__x86_64__)
        if (has_avx2()) return kernel::feel_avx2(tube, best);
#endif
        kernel::FieldKernel<xsimd::default_arch>::feel(tube, best);
    }

    // Onto the surface, and what each limb says there, weighted by how much it is felt.
    void finish(const mesh::Surface& surface, scene::Wood& wood) const {
        const std::size_t count = surface.positions.size();
        resize_vertices(wood, count);
        for (std::size_t first = 0; first < count;) {
            std::size_t last = first + 1;
            while (last < count && last < first + 8 && surface.blocks[last] == surface.blocks[first]) ++last;
            finish(surface, first, last, wood);
            first = last;
        }
    }

    // Up to eight vertices of one block.
    void finish(const mesh::Surface& surface, std::size_t first, std::size_t last, scene::Wood& wood) const {
        float points[3][8];
        for (std::size_t lane = 0; lane < 8; ++lane) {
            const glm::vec3& at = surface.positions[std::min(first + lane, last - 1)];
            for (int axis = 0; axis < 3; ++axis) points[axis][lane] = at[axis];
        }
        const std::uint32_t block = surface.blocks[first];
        const std::uint32_t* list = &lists_.pieces[lists_.first[block]];
        const std::size_t count = lists_.first[block + 1] - lists_.first[block];
        kernel::Told told;
        tell(pieces_.data(), list, count, points, told);
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t k = i - first;
            wood.mesh.positions_m[i] =
                origin_m_ + detail_.cell_m * glm::vec3{told.position[0][k], told.position[1][k], told.position[2][k]};
            wood.mesh.normals[i] = {told.normal[0][k], told.normal[1][k], told.normal[2][k]};
            wood.mesh.texcoords[i] = {detail_.cell_m * told.texcoord[0][k], told.texcoord[1][k]};
            wood.grains[i] = {told.grain[0][k], told.grain[1][k], told.grain[2][k], told.grain[3][k]};
            wood.ages[i] = age_at(skeleton_, told.path_m[k]);
            wood.sways[i] = told.sway[k];
        }
    }

    static void tell(const Piece* pieces, const std::uint32_t* list, std::size_t count, const float (&points)[3][8],
                     kernel::Told& told) {
#if defined(__x86_64__)
        if (has_avx2()) return kernel::tell_avx2(pieces, list, count, points, kSurface, told);
#endif
        kernel::SurfaceKernel<xsimd::default_arch>::tell(pieces, list, count, points, kSurface, told);
    }

    void append_twigs(scene::Wood& wood) const {
        TubeDetail thin;
        thin.trunk_sides = detail_.twig_sides;
        thin.has_foot = false;
        thin.flattest = 0.8F;
        const scene::Wood more = sweep_tubes(twigs_, thin);
        const auto first = static_cast<std::uint32_t>(wood.mesh.positions_m.size());
        const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
        append(wood.mesh.positions_m, more.mesh.positions_m);
        append(wood.mesh.normals, more.mesh.normals);
        append(wood.mesh.texcoords, more.mesh.texcoords);
        append(wood.grains, more.grains);
        append(wood.ages, more.ages);
        append(wood.sways, more.sways);
        for (const std::uint32_t index : more.mesh.indices) wood.mesh.indices.push_back(first + index);
    }

    const TreeSkeleton& skeleton_;
    MetaTubeDetail detail_;
    glm::vec3 origin_m_{0};
    std::vector<Piece> pieces_;
    Lists lists_;
    std::uint32_t limb_ = 0;
    TreeSkeleton twigs_;
    std::optional<SparseField> field_;
};

}  // namespace

float cell_for(const TreeSkeleton& skeleton, std::size_t triangles) {
    // Thin limbs are not in the field: what counts depends on the answer, so halve the interval.
    const auto triangles_at = [&](float cell_m) {
        float area_m2 = 0;
        for (const Limb& limb : skeleton.limbs) {
            if (limb.parent >= 0 && limb.nodes.front().radius_m < kThinnest * cell_m) continue;
            for (std::size_t i = 1; i < limb.nodes.size() && limb.nodes[i].radius_m >= kCut * cell_m; ++i)
                area_m2 += 3.1416F * (limb.nodes[i - 1].radius_m + limb.nodes[i].radius_m) *
                           glm::length(limb.nodes[i].at_m - limb.nodes[i - 1].at_m);
        }
        return 2.8F * area_m2 / (cell_m * cell_m);  // a surface crosses about 1.4 faces of two triangles a cell
    };
    float fine_m = 0.004F;
    float coarse_m = 1;
    for (int i = 0; i < 12; ++i) {
        const float middle_m = std::sqrt(fine_m * coarse_m);
        (triangles_at(middle_m) > static_cast<float>(triangles) ? fine_m : coarse_m) = middle_m;
    }
    return coarse_m;
}

scene::Wood mesh_meta_tubes(const TreeSkeleton& skeleton, const MetaTubeDetail& detail) {
    if (skeleton.limbs.empty()) return {};
    return MetaTubes(skeleton, detail).mesh();
}

}  // namespace quadrat::synthesis::trees
