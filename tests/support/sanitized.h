// The sanitizers slow tests down by more than ten: where cases are many they run fewer.
#pragma once

#ifdef SMB2D_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
