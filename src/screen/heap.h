// How the C library asks the system for memory.
#pragma once

namespace screen {

// For the whole process, before it allocates much: memory comes in huge pages where the system has them, and what is
// freed is kept. A system that hands out pages of 4 kB one by one takes longer over a large drawing than reading it
// does. Nothing where the allocator is not glibc's. Calls after the first do nothing.
void prepare_heap();

// The same for the calling thread, which has a heap of its own; after prepare_heap().
void prepare_heap_of_thread();

}  // namespace screen
