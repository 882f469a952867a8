#pragma once

#include <GL/osmesa.h>

namespace screen {

// OSMesa's functions. The library brings a compiler (LLVM) with it: it is loaded when something is first painted, not
// whenever the program starts, which takes four times as long.
struct Mesa {
    decltype(&OSMesaCreateContextAttribs) create_context;
    decltype(&OSMesaDestroyContext) destroy_context;
    decltype(&OSMesaMakeCurrent) make_current;
    decltype(&OSMesaGetProcAddress) function_called;
};

// Throws std::runtime_error where it is not installed.
Mesa const& mesa();

}  // namespace screen
