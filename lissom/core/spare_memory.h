#pragma once
/// Memory that the program has used and needs no more.

namespace lissom {

/// Hands pages that the allocator keeps for later back to the system, where it can be asked to (glibc). Takes some
/// milliseconds; worth it where something large has been put away for good.
void give_back_spare_memory();

}  // namespace lissom
