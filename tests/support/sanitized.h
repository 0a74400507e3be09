#pragma once

/// Whether the library is watched by the sanitizers: a step then takes tens of times longer, and tests try
/// fewer of the same things. Asked when they run, so that tests are compiled alike for every preset, and only
/// once.
bool isSanitized();
