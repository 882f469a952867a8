#include "screen/mesa.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace screen {
namespace {

template <typename Function>
void find(void* library, char const* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (function == nullptr) throw std::runtime_error(std::string(SMB2D_OSMESA) + " has no function " + name);
}

Mesa loaded() {
    // It stays until the program ends: contexts may live as long.
    void* const library = dlopen(SMB2D_OSMESA, RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr)
        throw std::runtime_error(std::string("Mesa's software OpenGL (OSMesa) cannot be loaded: ") + dlerror());
    Mesa mesa;
    find(library, "OSMesaCreateContextAttribs", mesa.create_context);
    find(library, "OSMesaDestroyContext", mesa.destroy_context);
    find(library, "OSMesaMakeCurrent", mesa.make_current);
    find(library, "OSMesaGetProcAddress", mesa.function_called);
    return mesa;
}

}  // namespace

Mesa const& mesa() {
    static Mesa const found = loaded();
    return found;
}

}  // namespace screen
