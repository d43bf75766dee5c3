// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.hpp"
#include "synthesis/trees/grammar.hpp"
#include "synthesis/trees/turtle.hpp"

namespace quadrat::synthesis::trees {
namespace {

using testing::HasSubstr;

std::string derived(const std::string& text, int steps, std::uint64_t seed = 1) {
    DeriveOptions options;
    options.steps = steps;
    options.seed = base::Seed{seed};
    return text_of(derive(read_grammar(text, "test"), options).word);
}

std::string refusal(const std::string& text) {
    try {
        read_grammar(text, "g.lsys");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(LSystem, DerivesTheBooksFigureTwoSixA) {
    const Grammar grammar = library_grammar("abop-a");
    const auto after = [&](int steps) {
        DeriveOptions options;
        options.steps = steps;
        return text_of(derive(grammar, options).word);
    };
    EXPECT_EQ(after(0), "A(1,10)");
    EXPECT_EQ(after(1), "!(10)F(1)[&(45)B(0.6,7.07)]/(137.5)A(0.9,7.07)");
    EXPECT_EQ(after(2),
              "!(10)F(1)[&(45)!(7.07)F(0.6)[-(45)$C(0.36,4.998)]C(0.54,4.998)]/(137.5)"
              "!(7.07)F(0.9)[&(45)B(0.54,4.998)]/(137.5)A(0.81,4.998)");
}

TEST(LSystem, HasTheBooksConstantsInItsFourTreesAndTheirChangedRelatives) {
    const char* first[] = {"[&(45)B(0.6,7.07)]", "[&(45)B(0.9,7.07)]", "[&(45)B(0.8,7.07)]", "[&(30)B(0.7,7.07)]"};
    for (const std::string kind : {"abop-", "changed-"}) {
        for (int i = 0; i < 4; ++i) {
            DeriveOptions options;
            options.steps = 1;
            const std::string name = kind + static_cast<char>('a' + i);
            EXPECT_THAT(text_of(derive(library_grammar(name), options).word), HasSubstr(first[i])) << name;
        }
    }
}

TEST(LSystem, TakesAGenesConstantInsteadOfItsOwn) {
    const Redefinition genes[] = {{"r2", 0.5F}, {"a0", 20}};
    DeriveOptions options;
    options.steps = 1;
    EXPECT_THAT(text_of(derive(library_grammar("abop-a", genes), options).word), HasSubstr("[&(20)B(0.5,7.07)]"));
}

TEST(LSystem, RewritesAllSymbolsAtOnce) {
    // Lindenmayer's alga: its lengths are Fibonacci's numbers.
    const std::string alga = "axiom: b\na -> ab\nb -> a\n";
    EXPECT_EQ(derived(alga, 5), "abaababa");
    EXPECT_EQ(derived(alga, 12).size(), 233U);
}

TEST(LSystem, AppliesAProductionOnlyWhereItsConditionHolds) {
    // ABOP section 1.10.1.
    const std::string g =
        "axiom: B(2)A(4,4)\n"
        "A(x,y) : y <= 3 -> A(x*2,x+y)\n"
        "A(x,y) : y > 3 -> B(x)A(x/y,0)\n"
        "B(x) : x < 1 -> C\n"
        "B(x) : x >= 1 -> B(x-1)\n";
    EXPECT_EQ(derived(g, 1), "B(1)B(4)A(1,0)");
    EXPECT_EQ(derived(g, 2), "B(0)B(3)A(2,1)");
    EXPECT_EQ(derived(g, 4), "CB(1)A(8,7)");
}

TEST(LSystem, ComputesWhatItsExpressionsSay) {
    EXPECT_EQ(derived("define: a = 2^3^0 - 1\ndefine: b = -(a + 1) * 3 / 2\naxiom: A(a,b)\n", 0), "A(1,-3)");
    EXPECT_EQ(derived("axiom: A(3)\nA(x) -> B(max(x,5)-min(x,5),sqrt(x*x),floor(x/2),abs(0-x))\n", 1), "B(2,3,1,3)");
    EXPECT_EQ(derived("axiom: A(3)\nA(x) : !(x > 4) && (x == 3 || x < 0) -> B\n", 1), "B");
    EXPECT_EQ(derived("axiom: A(0)\nA(x) -> B(1/x,sqrt(x-1),log(x))\n", 1), "B(0,0,0)");
}

TEST(LSystem, SeesTheContextOnBothSidesPastIgnoredSymbols) {
    // A signal that climbs: ABOP section 1.8.
    EXPECT_EQ(derived("axiom: baaa\nb < a -> b\nb -> a\n", 2), "aaba");
    EXPECT_EQ(derived("ignore: + -\naxiom: b+a-a\nb < a -> b\n", 1), "b+b-a");
    EXPECT_EQ(derived("axiom: ABC\nA < B > C -> X\n", 1), "AXC");
    EXPECT_EQ(derived("axiom: ABD\nA < B > C -> X\n", 1), "ABD");
    EXPECT_EQ(derived("outside: 0\naxiom: A[A]A\n0 < A > A -> B\nA < A > 0 -> C\n", 1), "B[C]C");
    EXPECT_EQ(derived("axiom: A(1)B(2)C(3)\nA(x) < B(y) > C(z) -> X(x,y,z)\n", 1), "A(1)X(1,2,3)C(3)");
}

TEST(LSystem, RefusesATropismThatNoPlaceCouldHold) {
    EXPECT_THAT(refusal("tropism: 0 -1 1e23 0.2\naxiom: F\n"), HasSubstr("g.lsys:1"));
    EXPECT_THAT(refusal("tropism: 0 -1 0 1e9\naxiom: F\n"), HasSubstr("-1000 to 1000"));
    EXPECT_EQ(refusal("tropism: 0 -1 0 0.2\naxiom: F\n"), "");
}

TEST(LSystem, BindsTheArgumentsOfAnySymbolWhereItHasThem) {
    const char* text = "axiom: C(5)ABA\n*(d) < A -> D(d)\n";
    EXPECT_EQ(derived(text, 1), "C(5)D(5)BA") << "B has no argument that d could be";
}

TEST(LSystem, ReadsContextsAlongTheAxisAcrossBranches) {
    // ABOP p. 32: BC < S > G[H]M in ABC[DE][SG[HI[JK]L]MNO].
    EXPECT_EQ(derived("axiom: ABC[DE][SG[HI[JK]L]MNO]\nBC < S > G[H]M -> X\n", 1), "ABC[DE][XG[HI[JK]L]MNO]");
    EXPECT_EQ(derived("axiom: A[B]C\nA < C -> X\n", 1), "A[B]X");
    EXPECT_EQ(derived("axiom: A[BC]D\nA > D -> X\n", 1), "X[BC]D");
    EXPECT_EQ(derived("axiom: [A]D\nA > D -> X\n", 1), "[A]D");
}

TEST(LSystem, ChoosesByChanceInTheSharesThatAreGivenAndTheSameForTheSameSeed) {
    const std::string g = "axiom: " + std::string(9000, 'F') + "\nF -(0.5)-> A\nF -(0.3)-> B\nF -(0.2)-> C\n";
    const std::string word = derived(g, 1);
    const auto count = [&](char c) { return static_cast<double>(std::ranges::count(word, c)); };
    EXPECT_NEAR(count('A'), 4500, 200);
    EXPECT_NEAR(count('B'), 2700, 190);
    EXPECT_NEAR(count('C'), 1800, 160);
    EXPECT_EQ(derived(g, 1), word);
    EXPECT_NE(derived(g, 1, 2), word);
    const std::string half = derived("axiom: " + std::string(4000, 'F') + "\nF -(0.5)-> A\n", 1);
    EXPECT_NEAR(static_cast<double>(std::ranges::count(half, 'F')), 2000, 130);
}

TEST(LSystem, UsesItsTablesInTurn) {
    const std::string g =
        "axiom: A\ntables: summer winter\nA -> A\ntable: summer\nB -> C\nA -> AB\ntable: winter\nB -> D\n";
    // The production above the tables stands in both and comes first, so only B changes.
    EXPECT_EQ(derived("axiom: AB\ntables: s w\ntable: s\nA -> AB\nB -> C\ntable: w\nB -> D\n", 1), "ABC");
    EXPECT_EQ(derived("axiom: AB\ntables: s w\ntable: s\nA -> AB\nB -> C\ntable: w\nB -> D\n", 2), "ADC");
    EXPECT_EQ(derived(g, 3), "A");
}

TEST(LSystem, GivesKellysFigureNineteenItsSignals) {
    const Grammar grammar = library_grammar("kelly-19");
    EXPECT_EQ(grammar.steps, 40);
    EXPECT_FLOAT_EQ(grammar.angle_deg, 22.5F);
    const char* first[] = {"F1F1F1", "F1F1F0", "F1F0F0", "F1F0F1", "F1F1F1F1"};
    for (int steps = 0; steps < 5; ++steps) {
        DeriveOptions options;
        options.steps = steps;
        EXPECT_EQ(text_of(derive(grammar, options).word), first[steps]);
    }
    EXPECT_GT(
        std::ranges::count_if(derive(grammar).word.symbols, [](const Word::Symbol& s) { return s.letter == '['; }), 10);
    const Derivation whole = derive(library_grammar("abop-1-31b"));
    EXPECT_GT(std::ranges::count_if(whole.word.symbols, [](const Word::Symbol& s) { return s.letter == '['; }), 10);
}

// As the thesis prints it, figure 19 names nothing beyond an axis's ends, and no rule of it can ever begin.
TEST(LSystem, NamesTheContextsThatNoWordCanOffer) {
    const auto kelly = std::ranges::find(grammar_library(), "kelly-19", &NamedGrammar::name);
    std::string printed(kelly->text);
    printed.erase(printed.find("outside: 0"), 10);
    const Grammar as_printed = read_grammar(printed, "printed");
    EXPECT_EQ(text_of(derive(as_printed).word), "F1F1F1");
    // Its two rules that turn the angles wait for any neighbour, and have one; but there is nothing to turn.
    EXPECT_EQ(contexts_in_vain(as_printed).size(), 9U);
    EXPECT_TRUE(contexts_in_vain(library_grammar("kelly-19")).empty());
    EXPECT_TRUE(contexts_in_vain(library_grammar("abop-1-31b")).empty());
    const Grammar hidden = read_grammar("ignore: C\naxiom: ABC\nA < B -> D\nB > C -> D\nA(x) < B -> D\n", "hidden");
    const auto vain = contexts_in_vain(hidden);
    ASSERT_EQ(vain.size(), 2U) << "one is ignored, one has no number";
    EXPECT_EQ(vain.front()->line, 4);
}

TEST(LSystem, StopsAWordThatExplodesAndNamesTheProductionThatDidIt) {
    const Grammar doubling = read_grammar("axiom: XY\nY -> Y\nX -> XX\n", "test");
    DeriveOptions options;
    options.steps = 60;
    options.most_symbols = 1000;
    const Derivation result = derive(doubling, options);
    EXPECT_EQ(result.word.symbols.size(), 513U);
    EXPECT_EQ(result.steps, 9);
    EXPECT_EQ(result.stopped_by, "X -> XX");
    EXPECT_EQ(result.stopped_by_line, 3);
}

TEST(LSystem, DerivesEveryGrammarThatComesWithTheProgram) {
    ASSERT_GE(grammar_library().size(), 16U);
    for (const NamedGrammar& one : grammar_library()) {
        const Derivation result = derive(read_grammar(one.text, std::string(one.name)));
        EXPECT_EQ(result.stopped_by, "") << one.name;
        EXPECT_GT(result.word.symbols.size(), 6U) << one.name;
    }
}

std::size_t organs_of(std::string_view text) {
    const Grammar grammar = read_grammar(text, "test");
    return interpret(derive(grammar).word, options_of(grammar), base::Seed{1}).sites.size();
}

TEST(LSystem, LettersThatOnlyStandForWhatTheyBecomeDrawNoOrgans) {
    // Hilbert's curve as most books print it.
    EXPECT_EQ(organs_of("steps: 3\nangle: 90\naxiom: L\nL -> +RF-LFL-FR+\nR -> -LF+RFR+FL-\n"), 0U);
    EXPECT_EQ(organs_of("steps: 2\naxiom: FK\nK -> KFK\n"), 0U);
    EXPECT_EQ(organs_of("steps: 1\naxiom: A\nA -> FLFK\n"), 2U) << "nothing becomes of these";
    EXPECT_EQ(organs_of("steps: 1\norgans: L\naxiom: FL\nL -> L\n"), 1U) << "the grammar says that it is a leaf";
    const auto bush = std::ranges::find(grammar_library(), "bush", &NamedGrammar::name);
    ASSERT_NE(bush, grammar_library().end());
    EXPECT_GT(organs_of(bush->text), 0U) << "as this one does";
    EXPECT_THAT(refusal("organs: A\naxiom: A\n"), HasSubstr("A is no organ; L and ~ are leaves, K is a flower"));
}

TEST(LSystem, NamesLineAndColumnOfWhatIsWrong) {
    EXPECT_THAT(refusal("axiom: A\nA -> B(x)\n"), HasSubstr("g.lsys:2:8: x is not a parameter"));
    EXPECT_THAT(refusal("axiom: A\nA = B\n"), HasSubstr("g.lsys:2:"));
    EXPECT_THAT(refusal("axiom: A\nAB -> C\n"), HasSubstr("a production replaces one symbol"));
    EXPECT_THAT(refusal("axiom: A\nA -> [B\n"), HasSubstr("g.lsys:2:8: a [ without its ]"));
    EXPECT_THAT(refusal("axiom: A\nA -> B]\n"), HasSubstr("g.lsys:2:8: a ] without its ["));
    EXPECT_THAT(refusal("axiom: A\nA -(1.5)-> B\n"), HasSubstr("a chance is more than 0 and at most 1"));
    EXPECT_THAT(refusal("A -> B\n"), HasSubstr("no axiom"));
    EXPECT_THAT(refusal("axiom: A\nangle: many\n"), HasSubstr("g.lsys:2:8: 'm' stands where a number should"));
    EXPECT_THAT(refusal("axiom: A\nsteps: 2.5\n"), HasSubstr("steps are a whole number"));
    EXPECT_THAT(refusal("axiom: A\ncolour: 3\n"), HasSubstr("g.lsys:2:1: colour: is not known"));
    EXPECT_THAT(refusal("axiom: A\ntables: winter\n"), HasSubstr("g.lsys:2:"));
    EXPECT_THAT(refusal("axiom: A\nA(x,x) -> B\n"), HasSubstr("a second parameter x"));
    EXPECT_THAT(refusal("axiom: A\n* -> B\n"), HasSubstr("* stands for any symbol of a context"));
    EXPECT_THAT(refusal("axiom: A\nA -> B(" + std::string(500, '(') + "1\n"), HasSubstr("nested too deeply"));
    EXPECT_THAT(refusal("axiom: A\naxiom: B\n"), HasSubstr("a second axiom"));
    EXPECT_THROW(library_grammar("abop-z"), base::InputError);
}

}  // namespace
}  // namespace quadrat::synthesis::trees
