// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "genome/aspect.hpp"
#include "genome/parameter_table.hpp"

namespace quadrat::genome {

// The genetic information as the 2003 paper has it: a bit vector an aspect; each parameter a run of bits, most
// significant first, in table order.
using Bits = std::vector<std::uint8_t>;  // each 0 or 1
using BitGenome = PerAspect<Bits>;

std::size_t bit_count(Aspect aspect, Genome genome);

// value = min + (max - min) k / (2^bits - 1), where k is the run read as a binary number.
// Asserts that each aspect has bit_count(aspect, genome) bits. Parameters outside the genome keep their default.
ParameterValues decode(const BitGenome& bits, Genome genome);

// The nearest genome to the values: decode(encode(v)) is v when v came from decode.
BitGenome encode(const ParameterValues& values, Genome genome);

std::string text_of(const Bits& bits);               // "0101…"
std::optional<Bits> bits_of(std::string_view text);  // nothing when there is another character than 0 and 1

}  // namespace quadrat::genome
