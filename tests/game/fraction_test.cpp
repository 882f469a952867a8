#include "game/fraction.h"

#include <doctest/doctest.h>

using game::Fraction;
using game::fraction_in;

TEST_CASE("a fraction of two whole numbers is kept exactly") {
    Fraction const every = fraction_in("1/24").value();
    CHECK(every.numerator == 1);
    CHECK(every.denominator == 24);
    CHECK(fraction_in("30000/1001").value().value() == 30000.0 / 1001.0);
    CHECK(fraction_in("6/4").value().denominator == 2);
}

TEST_CASE("a decimal number is kept as its digits over a power of ten") {
    Fraction const tenth = fraction_in("0.1").value();
    CHECK(tenth.numerator == 1);
    CHECK(tenth.denominator == 10);
    Fraction const small = fraction_in("2.5e-3").value();
    CHECK(small.numerator == 1);
    CHECK(small.denominator == 400);
    CHECK(fraction_in("1.5e3").value().value() == 1500);
    CHECK(fraction_in("-.5").value().value() == -0.5);
    CHECK(fraction_in("+2").value().value() == 2);
    CHECK(fraction_in("0").value().value() == 0);
}

TEST_CASE("a number with more digits than a double holds is the nearest double") {
    CHECK(fraction_in("0.3333333333333333333333").value().value() == 0.3333333333333333333333);
    CHECK(fraction_in("1e200").value().value() == 1e200);
    CHECK(fraction_in("1e-200").value().value() == 1e-200);
}

TEST_CASE("text that is no number is no fraction") {
    for (char const* text : {"",      "x",    "1/", "/2", "1/0", "1/-2", "1//2", "1/2/3", "nan", "inf",
                             "1e999", "0x10", "1 ", " 1", "1,5", "--1",  "+-1",  "1e",    ".",   "1/inf"})
        CHECK_MESSAGE(!fraction_in(text), text);
}

TEST_CASE("row i of every 1/24 s stands at the double nearest to i/24") {
    Fraction const every = fraction_in("1/24").value();
    for (long long i : {0LL, 1LL, 7LL, 24LL, 1000003LL})
        CHECK(game::multiple(i, every) == static_cast<double>(i) / 24.0);
    CHECK(game::multiple(3, fraction_in("0.1").value()) == 0.3);  // and not 0.1 + 0.1 + 0.1
    CHECK(game::multiple(600, fraction_in("1/60").value()) == 10.0);
}

TEST_CASE("a frame's time does not tell where its sequence began") {
    Fraction const rate = fraction_in("30000/1001").value();
    Fraction const zero = fraction_in("0").value(), later = fraction_in("1001/3000").value();  // 10 frames later
    for (long long i = 0; i < 1000; ++i)
        CHECK(game::frame_time(zero, i + 10, rate) == game::frame_time(later, i, rate));
    Fraction const tenth = fraction_in("0.1").value(), sixty = fraction_in("60").value();
    CHECK(game::frame_time(tenth, 12, sixty) == 0.3);
}

TEST_CASE("a sequence has as many frames as begin before its end") {
    auto const count = [](char const* from, char const* to, char const* rate) {
        return game::frames_between(fraction_in(from).value(), fraction_in(to).value(), fraction_in(rate).value());
    };
    CHECK(count("0", "1", "60") == 60);
    CHECK(count("0", "0.35", "10") == 4);
    CHECK(count("0.1", "0.4", "10") == 3);        // (0.4 - 0.1) * 10 is a little over 3 in doubles
    CHECK(count("0", "1.0000000001", "1") == 1);  // within 1e-9 of a whole number
    CHECK(count("0", "1.00000001", "1") == 2);
    CHECK(count("2", "2", "60") == 0);
}
