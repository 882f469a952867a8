#define GLAD_GL_IMPLEMENTATION
#include "screen/gl_table.h"

#include <stdexcept>

namespace screen {

GladGLContext gl_table(FindGlFunction find) {
    GladGLContext table{};
    int const version = gladLoadGLContext(&table, find);
    if (version < GLAD_MAKE_VERSION(3, 3)) throw std::runtime_error("OpenGL 3.3 is needed, and not there");
    return table;
}

}  // namespace screen
