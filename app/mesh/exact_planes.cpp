// SPDX-License-Identifier: Apache-2.0
// Questions about three and four planes by determinants (Sugihara & Iri 1989 represent solids so), floating-point
// filters before them as in Shewchuk 1997. What is ours: fixed-point planes, so that the exact stage is in whole
// numbers of known length and rectilinear, snapped and stacked planes meet exactly where they should.
#include "mesh/exact_planes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrat::mesh {
namespace {

__extension__ typedef unsigned __int128 Unsigned128;
constexpr double kEps = 0x1.0p-53;

int sign_of(double x) { return (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0); }

int compare_magnitude(const BigInteger& a, const BigInteger& b) {
    for (std::size_t i = a.limbs.size(); i-- > 0;)
        if (a.limbs[i] != b.limbs[i]) return a.limbs[i] < b.limbs[i] ? -1 : 1;
    return 0;
}

BigInteger added_magnitude(const BigInteger& a, const BigInteger& b) {
    BigInteger sum = a;
    Unsigned128 carry = 0;
    for (std::size_t i = 0; i < sum.limbs.size(); ++i) {
        carry += static_cast<Unsigned128>(a.limbs[i]) + b.limbs[i];
        sum.limbs[i] = static_cast<std::uint64_t>(carry);
        carry >>= 64U;
    }
    return sum;
}

BigInteger subtracted_magnitude(const BigInteger& larger, const BigInteger& smaller) {
    BigInteger difference = larger;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < difference.limbs.size(); ++i) {
        const Unsigned128 taken = static_cast<Unsigned128>(smaller.limbs[i]) + borrow;
        borrow = larger.limbs[i] < taken ? 1 : 0;
        difference.limbs[i] = larger.limbs[i] - static_cast<std::uint64_t>(taken);
    }
    return difference;
}

}  // namespace

BigInteger BigInteger::from(Int128 value) {
    BigInteger big;
    big.sign = (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
    const Unsigned128 magnitude = value < 0 ? -static_cast<Unsigned128>(value) : static_cast<Unsigned128>(value);
    big.limbs[0] = static_cast<std::uint64_t>(magnitude);
    big.limbs[1] = static_cast<std::uint64_t>(magnitude >> 64U);
    return big;
}

double BigInteger::rounded() const {
    double value = 0;
    for (std::size_t i = limbs.size(); i-- > 0;) value = value * 0x1.0p64 + static_cast<double>(limbs[i]);
    return sign * value;
}

BigInteger BigInteger::operator-() const {
    BigInteger negated = *this;
    negated.sign = -sign;
    return negated;
}

BigInteger operator*(const BigInteger& a, const BigInteger& b) {
    BigInteger product;
    product.sign = a.sign * b.sign;
    if (product.sign == 0) return product;
    constexpr std::size_t kLimbs = 6;
    for (std::size_t i = 0; i < kLimbs; ++i) {
        if (a.limbs[i] == 0) continue;
        Unsigned128 carry = 0;
        for (std::size_t j = 0; i + j < kLimbs; ++j) {
            carry += static_cast<Unsigned128>(a.limbs[i]) * b.limbs[j] + product.limbs[i + j];
            product.limbs[i + j] = static_cast<std::uint64_t>(carry);
            carry >>= 64U;
        }
    }
    return product;
}

BigInteger operator+(const BigInteger& a, const BigInteger& b) {
    if (a.sign == 0) return b;
    if (b.sign == 0) return a;
    if (a.sign == b.sign) return added_magnitude(a, b);
    const int order = compare_magnitude(a, b);
    if (order == 0) return {};
    return order > 0 ? subtracted_magnitude(a, b) : subtracted_magnitude(b, a);
}

MovingLine moving_line(std::int64_t nx, std::int64_t ny, std::int64_t offset, std::int64_t speed) {
    return {nx,
            ny,
            offset,
            speed,
            static_cast<double>(nx) * kNormalUnit,
            static_cast<double>(ny) * kNormalUnit,
            static_cast<double>(offset) * kOffsetUnit,
            static_cast<double>(speed) * kSpeedUnit};
}

int ExactPlanes::add(const MovingLine& line) {
    lines_.push_back(line);
    return static_cast<int>(lines_.size()) - 1;
}

Int128 ExactPlanes::cross(int i, int j) const {
    const MovingLine& a = (*this)[i];
    const MovingLine& b = (*this)[j];
    return static_cast<Int128>(a.nx) * b.ny - static_cast<Int128>(a.ny) * b.nx;
}

int ExactPlanes::turn(int i, int j) const {
    const MovingLine& a = (*this)[i];
    const MovingLine& b = (*this)[j];
    const double cross_d = a.nx_d * b.ny_d - a.ny_d * b.nx_d;
    if (std::abs(cross_d) > 8 * kEps) return sign_of(cross_d);
    const Int128 exact = cross(i, j);
    return (exact > 0 ? 1 : 0) - (exact < 0 ? 1 : 0);
}

bool ExactPlanes::has_direction_of(int i, int j) const {
    return is_parallel(i, j) && (*this)[i].nx_d * (*this)[j].nx_d + (*this)[i].ny_d * (*this)[j].ny_d > 0;
}

bool ExactPlanes::is_same(int i, int j) const {
    const MovingLine& a = (*this)[i];
    const MovingLine& b = (*this)[j];
    return i == j || (a.nx == b.nx && a.ny == b.ny && a.offset == b.offset && a.speed == b.speed);
}

// T(h) = sum over the three of (offset + speed h) cross(the other two): zero where they meet.
ExactPlanes::Determinants ExactPlanes::determinants(int i, int j, int k) const {
    const MovingLine& a = (*this)[i];
    const MovingLine& b = (*this)[j];
    const MovingLine& c = (*this)[k];
    const double bc = b.nx_d * c.ny_d - b.ny_d * c.nx_d;
    const double ca = c.nx_d * a.ny_d - c.ny_d * a.nx_d;
    const double ab = a.nx_d * b.ny_d - a.ny_d * b.nx_d;
    constexpr double kRoundings = 16 * kEps;
    return {a.offset_d * bc + b.offset_d * ca + c.offset_d * ab, a.speed_d * bc + b.speed_d * ca + c.speed_d * ab,
            kRoundings * (std::abs(a.offset_d) + std::abs(b.offset_d) + std::abs(c.offset_d)),
            kRoundings * (std::abs(a.speed_d) + std::abs(b.speed_d) + std::abs(c.speed_d))};
}

BigInteger ExactPlanes::exact_offsets(int i, int j, int k) const {
    const auto term = [this](int at, Int128 area) {
        return BigInteger::from(area) * BigInteger::from((*this)[at].offset);
    };
    return term(i, cross(j, k)) + term(j, cross(k, i)) + term(k, cross(i, j));
}

BigInteger ExactPlanes::exact_speeds(int i, int j, int k) const {
    const auto term = [this](int at, Int128 area) {
        return BigInteger::from(area) * BigInteger::from((*this)[at].speed);
    };
    return term(i, cross(j, k)) + term(j, cross(k, i)) + term(k, cross(i, j));
}

Meeting ExactPlanes::at_height(std::int64_t height) {
    Meeting m;
    m.given = height;
    m.height = static_cast<double>(height) * kHeightUnit;
    m.speed_sign = 1;
    return m;
}

Meeting ExactPlanes::meeting(int i, int j, int k) const {
    Meeting m;
    m.i = i;
    m.j = j;
    m.k = k;
    const Determinants d = determinants(i, j, k);
    if (std::abs(d.speeds) > 2 * d.speeds_error) {
        m.speed_sign = sign_of(d.speeds);
        m.height = -d.offsets / d.speeds;
        m.error = 2.1 * (d.offsets_error + std::abs(m.height) * d.speeds_error) / std::abs(d.speeds) +
                  4 * kEps * std::abs(m.height);
        return m;
    }
    const BigInteger speeds = exact_speeds(i, j, k);
    m.speed_sign = speeds.sign;
    if (m.speed_sign == 0) return m;
    m.height = -exact_offsets(i, j, k).rounded() / speeds.rounded() * kHeightUnit;
    m.error = 16 * kEps * std::abs(m.height);
    return m;
}

int ExactPlanes::compare(const Meeting& a, const Meeting& b) const {
    const double difference = a.height - b.height;
    if (std::abs(difference) > a.error + b.error) return sign_of(difference);
    if (difference == 0 && a.i == b.i && a.j == b.j && a.k == b.k && a.given == b.given) return 0;
    return exact_compare(a, b);
}

int ExactPlanes::exact_compare(const Meeting& a, const Meeting& b) const {
    const auto offsets = [this](const Meeting& m) {
        return m.i < 0 ? BigInteger::from(-m.given) : exact_offsets(m.i, m.j, m.k);
    };
    const auto speeds = [this](const Meeting& m) {
        return m.i < 0 ? BigInteger::from(1) : exact_speeds(m.i, m.j, m.k);
    };
    // -Ta/Sa against -Tb/Sb
    const BigInteger difference = offsets(b) * speeds(a) + -(offsets(a) * speeds(b));
    return difference.sign * a.speed_sign * b.speed_sign;
}

int ExactPlanes::side(int i, int j, int k, const Meeting& at) const {
    if (k == i || k == j) return 0;
    const Determinants d = determinants(i, j, k);
    const double value = d.offsets + at.height * d.speeds;
    const double error =
        2 * (d.offsets_error + std::abs(at.height) * d.speeds_error) + at.error * (std::abs(d.speeds) + d.speeds_error);
    if (std::abs(value) > error) return -sign_of(value) * turn(i, j);
    return exact_side(i, j, k, at);
}

int ExactPlanes::exact_side(int i, int j, int k, const Meeting& at) const {
    const BigInteger offsets = exact_offsets(i, j, k);
    const BigInteger speeds = exact_speeds(i, j, k);
    const BigInteger at_offsets = at.i < 0 ? BigInteger::from(-at.given) : exact_offsets(at.i, at.j, at.k);
    const BigInteger at_speeds = at.i < 0 ? BigInteger::from(1) : exact_speeds(at.i, at.j, at.k);
    const BigInteger value = offsets * at_speeds + -(at_offsets * speeds);
    return -value.sign * at_speeds.sign * turn(i, j);
}

bool ExactPlanes::is_same_point(std::array<int, 2> a, std::array<int, 2> b, const Meeting& at) const {
    return side(a[0], a[1], b[0], at) == 0 && side(a[0], a[1], b[1], at) == 0;
}

glm::dvec3 ExactPlanes::point(const Meeting& m) const {
    const MovingLine& a = (*this)[m.i];
    const MovingLine& b = (*this)[m.j];
    const MovingLine& c = (*this)[m.k];
    const double speeds = exact_speeds(m.i, m.j, m.k).rounded();
    const auto minor = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
        return BigInteger::from(static_cast<Int128>(p) * q - static_cast<Int128>(r) * s);
    };
    const auto solved = [&](std::int64_t na, std::int64_t nb, std::int64_t nc) {
        return (BigInteger::from(a.offset) * minor(nb, c.speed, nc, b.speed) +
                BigInteger::from(b.offset) * minor(nc, a.speed, na, c.speed) +
                BigInteger::from(c.offset) * minor(na, b.speed, nb, a.speed))
                   .rounded() /
               speeds;
    };
    constexpr double kUnit = kOffsetUnit / kNormalUnit;
    const double height = -exact_offsets(m.i, m.j, m.k).rounded() / speeds * kHeightUnit;
    return {kUnit * solved(a.ny, b.ny, c.ny), -kUnit * solved(a.nx, b.nx, c.nx), height};
}

glm::dvec2 ExactPlanes::point(int i, int j, double height) const {
    const MovingLine& a = (*this)[i];
    const MovingLine& b = (*this)[j];
    const double at_a = a.offset_d + a.speed_d * height;
    const double at_b = b.offset_d + b.speed_d * height;
    const double area = a.nx_d * b.ny_d - a.ny_d * b.nx_d;
    return {(at_a * b.ny_d - at_b * a.ny_d) / area, (at_b * a.nx_d - at_a * b.nx_d) / area};
}

}  // namespace quadrat::mesh
