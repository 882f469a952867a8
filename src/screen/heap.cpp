#include "screen/heap.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <mutex>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace screen {

#ifdef __GLIBC__

namespace {

constexpr int first_growth = 256 << 20, later_growth = 16 << 20;  // bytes of addresses, not yet of memory
// A frame takes megabytes of passing memory. Left to itself glibc gives much of them back to the system after each
// frame and has them faulted in again, which costs a tenth of painting and more of the slowest frames.
constexpr int kept = 1 << 30, largest_in_heap = 32 << 20;  // bytes; glibc takes no larger second threshold
constexpr std::size_t of_thread = 28 << 20;                // bytes, twice: a thread's heap has 64 MB at most

void advise_huge_pages(char* begin, char* end) {
    auto const page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    auto const past = reinterpret_cast<std::uintptr_t>(begin) % page;
    if (past > 0) begin += page - past;
    // Advice: where it is not taken, pages are small.
    if (begin < end) madvise(begin, static_cast<std::size_t>(end - begin), MADV_HUGEPAGE);
}

// Volatile, since a compiler may leave out what is freed at once.
char* allocated(std::size_t bytes) {
    void* volatile const block = std::malloc(bytes);
    return static_cast<char*>(block);
}

// Set where glibc's own allocator is not replaced by another, such as the address sanitizer's, which takes no options.
std::atomic<bool> is_glibcs = false;

void grow_main_heap() {
    if (mallopt(M_TRIM_THRESHOLD, kept) == 0) return;
    is_glibcs = true;
    mallopt(M_MMAP_THRESHOLD, largest_in_heap);
    mallopt(M_TOP_PAD, first_growth);
    char* const before = static_cast<char*>(sbrk(0));
    std::free(allocated(later_growth));
    advise_huge_pages(before, static_cast<char*>(sbrk(0)));
    mallopt(M_TOP_PAD, later_growth);
}

}  // namespace

void prepare_heap() {
    static std::once_flag once;
    std::call_once(once, grow_main_heap);
}

void prepare_heap_of_thread() {
    if (!is_glibcs) return;
    char* const blocks[] = {allocated(of_thread), allocated(of_thread)};
    for (char* const block : blocks) {
        if (block != nullptr) advise_huge_pages(block, block + of_thread);
        std::free(block);
    }
}

#else

void prepare_heap() {}
void prepare_heap_of_thread() {}

#endif

}  // namespace screen
