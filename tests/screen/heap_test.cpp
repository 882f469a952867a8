#include "screen/heap.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <cstring>
#include <thread>

#ifdef __GLIBC__
#include <sys/resource.h>
#endif

// The address sanitizer brings an allocator of its own.
#if defined(__GLIBC__) && !defined(SMB2D_SANITIZED)

namespace {

constexpr std::size_t frame = 8 << 20;  // bytes, 2048 pages
constexpr long few = 16;                // pages

long page_faults() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_minflt;
}

long faults_of_a_frame() {
    long const before = page_faults();
    void* volatile const block = std::malloc(frame);
    std::memset(block, 1, frame);
    std::free(block);
    return page_faults() - before;
}

}  // namespace

TEST_CASE("what one frame frees the next one takes without asking the system for memory") {
    screen::prepare_heap();
    faults_of_a_frame();
    CHECK(faults_of_a_frame() < few);
    std::thread([] {
        screen::prepare_heap_of_thread();
        faults_of_a_frame();
        CHECK(faults_of_a_frame() < few);
    }).join();
}

#endif
