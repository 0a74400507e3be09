#pragma once

namespace esm {

/// Lets the calling thread, and those it starts, take less of the processors where all are busy. Never takes
/// nothing: what it holds, such as the process's memory map, others may wait for.
/// @param niceness 0 to 19: each 5 more is about a third of the share
void giveWay(int niceness);

} // namespace esm
