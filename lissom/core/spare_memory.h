#pragma once
/// Memory that the program has used and needs no more.

namespace lissom {

/// Blocks of half a megabyte and more come from the system one by one and go back as they are freed (glibc; its own bound grows
/// with use). Among small blocks they would leave gaps that never close: for programs that run all day. To be called
/// before anything large is made.
void keep_large_blocks_apart();

/// Hands pages that the allocator keeps for later back to the system, where it can be asked to (glibc). Takes some
/// milliseconds; worth it where something large has been put away for good.
void give_back_spare_memory();

}  // namespace lissom
