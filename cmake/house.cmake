# What everything of ours is built with, and the floors of the house. Also what tests/bits builds by itself with other
# compilers: whatever decides about bits stands here.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH HOUSE)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

option(SMB2D_STRICT "warnings are errors" OFF)
option(SMB2D_SANITIZE "build with the address and undefined behaviour sanitizers" OFF)

# What was compiled once need not be compiled again. The cache sees a precompiled header as the compiler does, by what it
# was made of.
find_program(SMB2D_CACHE ccache DOC "compiler cache, used where there is one")
if(SMB2D_CACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${SMB2D_CACHE})
endif()

# No fused multiply-add and no vector products of Eigen's: the same run gives the same bits on every compiler and at
# every level of optimisation.
find_package(Eigen3 3.4 REQUIRED)
add_library(house INTERFACE)
target_link_libraries(house INTERFACE Eigen3::Eigen)
target_include_directories(house INTERFACE ${HOUSE}/src)
target_compile_definitions(house INTERFACE EIGEN_DONT_VECTORIZE EIGEN_MPL2_ONLY)
target_compile_options(house INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic)
# A local name may be that of a constant of another file: files are compiled together.
target_compile_options(house INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>)
# SDL wants it wherever it is included; precompiled headers are for those that define the same.
target_compile_definitions(house INTERFACE _REENTRANT)
# g++ 12 warns of strings and variants that it has itself copied wrongly while inlining (its bugs 105329, 105562, 105651).
target_compile_options(house INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized
    -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread>)
# Vectorising, g++ 12 makes a fused multiply-add of a product added and subtracted (a rotation), whatever -ffp-contract is.
target_compile_options(house INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-vectorize -fno-tree-slp-vectorize>)
if(SMB2D_STRICT)
    target_compile_options(house INTERFACE -Werror)
endif()
if(SMB2D_SANITIZE)
    # Of what is known of lines for messages the least, and little optimised, what is BRIEF not at all: more costs more to
    # compile than it saves.
    # Whether a reference that is bound is null or leads beyond an object shows with the address sanitizer once it is
    # used; asked at every binding of Eigen's it takes a third of the time to compile.
    target_compile_options(house INTERFACE $<IF:$<BOOL:$<TARGET_PROPERTY:BRIEF>>,-O0,-O1>
        -fsanitize=address,undefined -fno-sanitize-recover=undefined
        -fno-sanitize=null,alignment,object-size,pointer-overflow -fno-omit-frame-pointer
        $<IF:$<CXX_COMPILER_ID:Clang>,-gline-tables-only,-g1>)
    target_link_options(house INTERFACE -fsanitize=address,undefined)
    # A third of the time of the usual one.
    find_program(SMB2D_LLD ld.lld DOC "LLVM's linker, used where there is one")
    if(SMB2D_LLD)
        target_link_options(house INTERFACE -fuse-ld=lld)
    endif()
endif()

# What takes longer to optimise, sanitized, than it runs.
define_property(TARGET PROPERTY BRIEF)

# What nearly all files include, compiled once for all that is optimised alike.
set(HOUSE_HEADERS <algorithm> <array> <cmath> <cstdint> <deque> <functional> <limits> <map> <memory> <optional> <span>
    <stdexcept> <string> <utility> <variant> <vector> <Eigen/Core>)

function(share_headers target)
    get_target_property(brief ${target} BRIEF)
    if(SMB2D_SANITIZE AND brief)
        set(owner game)
    else()
        set(owner geometry)
    endif()
    if(target STREQUAL owner)
        target_precompile_headers(${target} PRIVATE ${HOUSE_HEADERS})
    else()
        target_precompile_headers(${target} REUSE_FROM ${owner})
    endif()
endfunction()

# A floor of the house: the folder src/NAME as a static library that may include the floors named after it.
function(add_floor name)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${HOUSE}/src/${name}/*.cpp)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC house ${ARGN})
    if(name MATCHES "^(game|screen)$")
        set_target_properties(${name} PROPERTIES BRIEF ON)
    endif()
    share_headers(${name})
endfunction()
