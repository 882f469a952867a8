// The languages that there are, a file each.
#pragma once

#include <span>

#include "game/texts.h"

namespace game {

std::span<TextEntry const> english_texts();
std::span<TextEntry const> german_texts();

}  // namespace game
