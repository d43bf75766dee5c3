// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

// Lines that move at a steady speed along their normals, that is, planes over the ground, and the questions that decide
// how they meet. Each question is answered by floating point where its error bound allows that, by whole numbers
// otherwise, so that every answer is exact.
namespace quadrat::mesh {

__extension__ typedef __int128 Int128;

// A whole number of at most 384 bits.
struct BigInteger {
    std::array<std::uint64_t, 6> limbs{};  // the magnitude, least first
    int sign = 0;

    static BigInteger from(Int128 value);
    double rounded() const;
    friend BigInteger operator*(const BigInteger& a, const BigInteger& b);
    friend BigInteger operator+(const BigInteger& a, const BigInteger& b);
    BigInteger operator-() const;
};

// All points p with normal . p = offset + speed * height. Fixed point: the normal in units of 2^-50, the offset of
// 2^-44, the speed of 2^-28, a height of 2^-16. The interior is where normal . p is larger.
struct MovingLine {
    std::int64_t nx = 0, ny = 0;                           // of unit length but for rounding; at most 2^50
    std::int64_t offset = 0;                               // at most 2^60
    std::int64_t speed = 0;                                // at most 2^34
    double nx_d = 0, ny_d = 0, offset_d = 0, speed_d = 0;  // the same, as numbers
};

constexpr double kNormalUnit = 0x1.0p-50;
constexpr double kOffsetUnit = 0x1.0p-50;
constexpr double kSpeedUnit = 0x1.0p-28;
constexpr double kHeightUnit = 0x1.0p-22;

MovingLine moving_line(std::int64_t nx, std::int64_t ny, std::int64_t offset, std::int64_t speed);

// A height where three lines pass through one point, or one that is given.
struct Meeting {
    int i = -1, j = -1, k = -1;  // i < 0: the height is given
    std::int64_t given = 0;      // in units of 2^-22
    double height = 0;
    double error = 0;    // the true height is within height ± error
    int speed_sign = 0;  // of the determinant of normals and speeds; 0: they never meet, or always do
};

class ExactPlanes {
  public:
    int add(const MovingLine& line);
    const MovingLine& operator[](int i) const { return lines_[static_cast<std::size_t>(i)]; }
    std::size_t size() const { return lines_.size(); }

    // The sign of the cross product of two normals: +1 where j turns left of i.
    int turn(int i, int j) const;
    bool is_parallel(int i, int j) const { return turn(i, j) == 0; }
    bool has_direction_of(int i, int j) const;  // parallel, and not opposite
    bool is_same(int i, int j) const;

    static Meeting at_height(std::int64_t height);
    Meeting meeting(int i, int j, int k) const;
    int compare(const Meeting& a, const Meeting& b) const;  // of their heights; both have a speed_sign

    // On which side of line k is the point of lines i and j (not parallel) at this meeting's height? +1: inside.
    int side(int i, int j, int k, const Meeting& at) const;
    // The same height, where two vertices are one point?
    bool is_same_point(std::array<int, 2> a, std::array<int, 2> b, const Meeting& at) const;

    glm::dvec3 point(const Meeting& meeting) const;  // of three lines, to the nearest numbers
    glm::dvec2 point(int i, int j, double height) const;

  private:
    struct Determinants {
        double offsets, speeds, offsets_error, speeds_error;
    };
    Int128 cross(int i, int j) const;
    Determinants determinants(int i, int j, int k) const;
    BigInteger exact_offsets(int i, int j, int k) const;
    BigInteger exact_speeds(int i, int j, int k) const;
    int exact_compare(const Meeting& a, const Meeting& b) const;
    int exact_side(int i, int j, int k, const Meeting& at) const;

    std::vector<MovingLine> lines_;
};

}  // namespace quadrat::mesh
