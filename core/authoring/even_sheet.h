#pragma once

#include "core/project/project.h"
#include "core/support/progress.h"

namespace esm {

/// Whether an even sheet can be made of the organ: a surface of springs, neither filled nor rigid.
bool canBeEvenSheet(const Project& project);

/// The same organ with springs that make an even sheet of it, or with springs that all have their tissue's
/// constant as it is. Nodes and scene stay; steps and errors have to be measured again.
/// Precondition: it can be one. @throws Cancelled
Project withEvenSheet(const Project& project, bool isEven, const Progress& progress = {});

} // namespace esm
