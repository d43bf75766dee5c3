// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <xsimd/xsimd.hpp>

// What limbs say at points of their common surface, eight points at once. Compiled once for the baseline and once for
// processors with AVX2, to the same bits; nothing else may be included here, so that no code of a wider set escapes
// into the rest.
namespace quadrat::synthesis::trees::kernel {

// A tapering piece of a limb. Lengths in samples, unless they say otherwise.
struct Piece {
    enum Field : std::size_t {
        FromX,
        FromY,
        FromZ,  // its beginning
        AlongX,
        AlongY,
        AlongZ,  // to its end
        PerLength2,
        PerReach,      // 1 / reach at its beginning; it runs evenly to the end: a division a piece, not one a sample
        PerReachMore,  // at its end, more than at its beginning; the same below
        Path_m,
        PathMore_m,
        Sway,
        SwayMore,
        SideX,
        SideY,
        SideZ,  // its frame: what bark coordinates count from,
        UpX,
        UpY,
        UpZ,  // across that and the limb,
        AheadX,
        AheadY,
        AheadZ,  // and along it; unit
        Fields
    };
    std::array<float, Fields> is;
    float reach;  // the wider end's
    std::uint32_t limb;
};

// Of eight points, by component.
struct Told {
    float position[3][8];
    float normal[3][8];
    float texcoord[2][8];  // across, in samples, from its limb's side; along, m
    float grain[4][8];     // the limb's direction; w: how far the side runs with it, -1 to 1
    float path_m[8];
    float sway[8];
};

template <typename Arch>
struct SurfaceKernel {
    using F = xsimd::batch<float, Arch>;
    static constexpr std::size_t kLanes = F::size;
    static_assert(8 % kLanes == 0);

    struct Vector {
        F x, y, z;
    };
    static F dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

    // The angle of (x, y), y not less than 0, to a thousandth: 0 to pi.
    static F turn_of(F x, F y) {
        const F ax = xsimd::abs(x);
        const F t = xsimd::min(ax, y) / xsimd::max(xsimd::max(ax, y), F(1.0e-12F));
        const F t2 = t * t;
        F angle = t * (F(0.99978784F) + t2 * (F(-0.32580840F) + t2 * (F(0.15557865F) - F(0.04432655F) * t2)));
        angle = xsimd::select(y > ax, F(1.57079633F) - angle, angle);
        return xsimd::select(x < F(0.0F), F(3.14159265F) - angle, angle);
    }

    // One limb's nearest piece for each lane.
    struct Nearest {
        F share = F(1.0F);  // distance over reach, squared
        F t = F(0.0F);      // along the piece
        F which = F(0.0F);  // of the limb's pieces
    };

    static void compare(const Piece& piece, std::size_t number, const Vector& at, Nearest& nearest) {
        const auto is = [&piece](Piece::Field field) { return F(piece.is[field]); };
        const Vector along{is(Piece::AlongX), is(Piece::AlongY), is(Piece::AlongZ)};
        const Vector d{at.x - is(Piece::FromX), at.y - is(Piece::FromY), at.z - is(Piece::FromZ)};
        const F t = xsimd::min(xsimd::max(dot(d, along) * is(Piece::PerLength2), F(0.0F)), F(1.0F));
        const Vector off{d.x - t * along.x, d.y - t * along.y, d.z - t * along.z};
        const F per = is(Piece::PerReach) + t * is(Piece::PerReachMore);
        const F share = dot(off, off) * (per * per);
        const auto is_nearer = share < nearest.share;
        nearest.share = xsimd::select(is_nearer, share, nearest.share);
        nearest.t = xsimd::select(is_nearer, t, nearest.t);
        nearest.which = xsimd::select(is_nearer, F(static_cast<float>(number)), nearest.which);
    }

    // Weighted by how much each limb is felt.
    struct Heard {
        Vector gradient{F(0.0F), F(0.0F), F(0.0F)};
        F weight = F(0.0F);  // the field
        F path_m = F(0.0F);
        F sway = F(0.0F);
        F says = F(0.0F);
        F across = F(0.0F);
        F along_m = F(0.0F);
        Vector grain{F(0.0F), F(0.0F), F(0.0F)};
        F side = F(0.0F);
    };

    static void hear(const Piece* pieces, const std::uint32_t* of_limb, const Nearest& nearest, const Vector& at,
                     Heard& heard) {
        float which[kLanes];
        nearest.which.store_unaligned(which);
        float lanes[Piece::Fields][kLanes];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const Piece& piece = pieces[of_limb[static_cast<std::size_t>(which[lane])]];
            for (std::size_t field = 0; field < Piece::Fields; ++field) lanes[field][lane] = piece.is[field];
        }
        const auto is = [&lanes](Piece::Field field) { return F::load_unaligned(lanes[field]); };
        const F t = nearest.t;
        const Vector off{at.x - is(Piece::FromX) - t * is(Piece::AlongX),
                         at.y - is(Piece::FromY) - t * is(Piece::AlongY),
                         at.z - is(Piece::FromZ) - t * is(Piece::AlongZ)};
        const F per = is(Piece::PerReach) + t * is(Piece::PerReachMore);
        const F rest = F(1.0F) - nearest.share;
        const F weight = rest * rest * rest;
        const F steep = F(6.0F) * rest * rest * per * per;
        heard.gradient.x -= steep * off.x;
        heard.gradient.y -= steep * off.y;
        heard.gradient.z -= steep * off.z;
        heard.weight += weight;
        const F path_m = is(Piece::Path_m) + t * is(Piece::PathMore_m);
        heard.path_m += weight * path_m;
        heard.sway += weight * (is(Piece::Sway) + t * is(Piece::SwayMore));
        const F x = dot(off, {is(Piece::SideX), is(Piece::SideY), is(Piece::SideZ)});
        const F y = dot(off, {is(Piece::UpX), is(Piece::UpY), is(Piece::UpZ)});
        const F around2 = x * x + y * y;
        const F around = xsimd::sqrt(around2);
        // Behind a limb's end there is no way around it: it has nothing to say about its bark there.
        const F says = weight * (around2 / xsimd::max(dot(off, off), F(1.0e-9F)) + F(1.0e-4F));
        heard.says += says;
        heard.across += says * turn_of(x, xsimd::abs(y)) * around;
        heard.along_m += says * path_m;
        heard.grain.x += weight * is(Piece::AheadX);
        heard.grain.y += weight * is(Piece::AheadY);
        heard.grain.z += weight * is(Piece::AheadZ);
        heard.side += weight * y / xsimd::max(around, F(1.0e-6F));
    }

    // One step of Newton's toward the surface, within the cell.
    static Vector stepped(const Vector& at, const Heard& heard, float surface) {
        const F steep2 = dot(heard.gradient, heard.gradient);
        const F by = (F(surface) - heard.weight) / xsimd::max(steep2, F(1.0e-8F));
        const F length = xsimd::abs(by) * xsimd::sqrt(steep2);
        const F less = xsimd::select(length > F(0.25F), F(0.25F) / xsimd::max(length, F(0.25F)), F(1.0F));
        const F step = xsimd::select(steep2 > F(1.0e-8F), by * less, F(0.0F));
        return {at.x + heard.gradient.x * step, at.y + heard.gradient.y * step, at.z + heard.gradient.z * step};
    }

    // v over its length times sign, or straight up where it has none.
    static void store_unit(const Vector& v, float sign, float (*to)[8], std::size_t first) {
        const F length = xsimd::sqrt(dot(v, v));
        const auto is_some = length > F(1.0e-6F);
        const F per = F(sign) / xsimd::max(length, F(1.0e-6F));
        xsimd::select(is_some, v.x * per, F(0.0F)).store_unaligned(to[0] + first);
        xsimd::select(is_some, v.y * per, F(1.0F)).store_unaligned(to[1] + first);
        xsimd::select(is_some, v.z * per, F(0.0F)).store_unaligned(to[2] + first);
    }

    // list: the pieces that may be felt at the points, those of a limb one after the other. surface: the field's there.
    static void tell(const Piece* pieces, const std::uint32_t* list, std::size_t count, const float (&points)[3][8],
                     float surface, Told& told) {
        for (std::size_t lane = 0; lane < 8; lane += kLanes) {
            const Vector at{F::load_unaligned(points[0] + lane), F::load_unaligned(points[1] + lane),
                            F::load_unaligned(points[2] + lane)};
            Heard heard;
            for (std::size_t k = 0; k < count;) {
                const std::size_t first = k;
                Nearest nearest;
                for (; k < count && pieces[list[k]].limb == pieces[list[first]].limb; ++k)
                    compare(pieces[list[k]], k - first, at, nearest);
                if (xsimd::any(nearest.share < F(1.0F))) hear(pieces, list + first, nearest, at, heard);
            }
            const Vector position = stepped(at, heard, surface);
            position.x.store_unaligned(told.position[0] + lane);
            position.y.store_unaligned(told.position[1] + lane);
            position.z.store_unaligned(told.position[2] + lane);
            store_unit(heard.gradient, -1, told.normal, lane);
            store_unit(heard.grain, 1, told.grain, lane);
            const F per_says = F(1.0F) / xsimd::max(heard.says, F(1.0e-9F));
            (heard.across * per_says).store_unaligned(told.texcoord[0] + lane);
            (heard.along_m * per_says).store_unaligned(told.texcoord[1] + lane);
            const F per_weight = F(1.0F) / xsimd::max(heard.weight, F(1.0e-6F));
            xsimd::min(xsimd::max(heard.side * per_weight, F(-1.0F)), F(1.0F)).store_unaligned(told.grain[3] + lane);
            (heard.path_m * per_weight).store_unaligned(told.path_m + lane);
            xsimd::min(xsimd::max(heard.sway * per_weight, F(0.0F)), F(1.0F)).store_unaligned(told.sway + lane);
        }
    }
};

void tell_avx2(const Piece* pieces, const std::uint32_t* list, std::size_t count, const float (&points)[3][8],
               float surface, Told& told);

}  // namespace quadrat::synthesis::trees::kernel
