#include "game/actions.h"

#include <set>

#include <doctest/doctest.h>

using game::KeyAction;
using Keys = std::vector<std::string>;

namespace {

// Keyboards whose keys are called by one capital letter, besides those that actions come with.
std::string known(std::string const& key) {
    if (key.size() == 1 && key[0] >= 'a' && key[0] <= 'z') return {static_cast<char>(key[0] - 'a' + 'A')};
    bool const is_usual = game::action_of(game::usual_bindings(), key).has_value();
    return is_usual || (key.size() == 1 && key[0] >= 'A' && key[0] <= 'Z') ? key : "";
}

int owners_of(game::Bindings const& bindings, std::string const& key) {
    int owners = 0;
    for (Keys const& keys : bindings.keys)
        for (std::string const& own : keys) owners += own == key ? 1 : 0;
    return owners;
}

}  // namespace

TEST_CASE("every action has a row in its place, a name of its own, a text and keys that no other has") {
    REQUIRE(game::actions().size() == game::action_count);
    std::set<std::string> names, keys;
    for (std::size_t i = 0; i < game::action_count; ++i) {
        game::ActionRow const& row = game::actions()[i];
        CHECK(row.action == static_cast<KeyAction>(i));
        CHECK(names.insert(row.name).second);
        CHECK(!game::words(row.text, game::Language::english).empty());
        CHECK(!row.keys.empty());
        for (std::string const& key : row.keys) CHECK(keys.insert(key).second);
    }
}

TEST_CASE("where nothing is chosen keys are as they came, and nothing is told") {
    game::Bound const bound = game::bindings_of({}, known);
    CHECK(bound.bindings == game::usual_bindings());
    CHECK(bound.faults.empty());
    CHECK(game::action_of(bound.bindings, "Space") == KeyAction::pause);
    CHECK(!game::action_of(bound.bindings, "J"));
}

TEST_CASE("a key that is chosen is taken from the action that came with it") {
    game::Bound const bound = game::bindings_of({{"pause", {"a"}}}, known);
    CHECK(bound.bindings.of(KeyAction::pause) == Keys{"A"});
    CHECK(bound.bindings.of(KeyAction::tilt_left) == Keys{"Left"});
    CHECK(!game::action_of(bound.bindings, "Space"));
    CHECK(bound.faults.empty());
}

TEST_CASE("what the file says wrong is told, a line each, and the rest holds") {
    game::Bound const bound = game::bindings_of({{"pause", {"Spcae"}},
                                                 {"save", {"X", "Fünf"}},
                                                 {"method", {"X"}},
                                                 {"levels", {}},
                                                 {"restart", {"S"}},
                                                 {"jump", {"J"}}},
                                                known);
    std::multiset<std::string> const faults(bound.faults.begin(), bound.faults.end());
    CHECK(faults ==
          std::multiset<std::string>{"keys: there is no action \"jump\"", "keys: pause: there is no key \"Spcae\"",
                                     "keys: \"X\" stands for method already, not for save",
                                     "keys: save: there is no key \"Fünf\"", "keys: slow-motion has no key any more"});
    CHECK(bound.bindings.of(KeyAction::pause) == Keys{"Space"});
    CHECK(bound.bindings.of(KeyAction::levels).empty());
    CHECK(bound.bindings.of(KeyAction::restart) == Keys{"S"});
}

TEST_CASE("a new key that another action has changes places with the old one") {
    game::Rebound const swapped = game::rebound(game::usual_bindings(), KeyAction::pause, "R");
    CHECK(swapped.other == KeyAction::restart);
    CHECK(swapped.bindings.of(KeyAction::pause) == Keys{"R"});
    CHECK(swapped.bindings.of(KeyAction::restart) == Keys{"Space"});
    SUBCASE("but for one that has more of them") {
        game::Rebound const taken = game::rebound(game::usual_bindings(), KeyAction::pause, "Left");
        CHECK(taken.other == KeyAction::tilt_left);
        CHECK(taken.bindings.of(KeyAction::tilt_left) == Keys{"A"});
        CHECK(!game::action_of(taken.bindings, "Space"));
    }
    SUBCASE("nor where it is its own, or nobody's") {
        CHECK(!game::rebound(game::usual_bindings(), KeyAction::tilt_left, "A").other);
        CHECK(!game::rebound(game::usual_bindings(), KeyAction::pause, "J").other);
    }
}

TEST_CASE("whatever is chosen after whatever, a key stands for one action and none is without, and files hold it") {
    game::Bindings bindings = game::usual_bindings();
    std::vector<std::string> every;
    for (Keys const& keys : bindings.keys) every.insert(every.end(), keys.begin(), keys.end());
    for (std::size_t i = 0; i < 400; ++i) {
        KeyAction const action = static_cast<KeyAction>(i * 7 % game::action_count);
        bindings = game::rebound(bindings, action, every[i * 11 % every.size()]).bindings;
        for (std::string const& key : every) CHECK(owners_of(bindings, key) <= 1);
        for (Keys const& keys : bindings.keys) CHECK(!keys.empty());
    }
    game::ChosenKeys const chosen = game::chosen_keys(bindings, {{"of a later program", {"J"}}});
    CHECK(chosen.contains("of a later program"));
    CHECK(game::bindings_of(chosen, known).bindings == bindings);
    CHECK(game::chosen_keys(game::usual_bindings(), chosen).size() == 1);
}
