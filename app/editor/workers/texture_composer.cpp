#include "app/editor/workers/texture_composer.h"

#include "core/support/errors.h"

#include <algorithm>
#include <chrono>

namespace esm {

TextureComposer::TextureComposer(QObject* parent)
    : QObject(parent), m_worker([this](const Worker::Task& task) { return compositionOf(task); },
                                [this] { emit composed(); }) {}

TextureComposer::Composed TextureComposer::composition() const {
    const Outcome<Composed> outcome = m_worker.outcome();
    if (outcome.failure.empty()) return outcome.answer;
    Composed none;
    none.failure = outcome.failure;
    return none;
}

/// Whether what is kept shows a project's layers.
bool TextureComposer::lies(const Project& project) const {
    const Composition& kept = m_kept.composition;
    return kept.pages && kept.baseColour == project.texture.baseColour &&
           std::equal(kept.layers.begin(), kept.layers.end(), project.layers.begin(), project.layers.end(),
                      looksTheSame);
}

/// Brings what is kept up to date with a project's layers.
void TextureComposer::keepPages(const Worker::Task& task) {
    const Project& project = task.question;
    if (m_kept.mesh != project.mesh) m_kept = {project.mesh, nullptr, {}, nullptr, {}};
    if (m_kept.atlas != project.atlas) {
        m_kept.composition = {};
        m_kept.smaller = nullptr;
    }
    m_kept.atlas = project.atlas;
    const Progress goOn = task.progress(
        [&](const Project& next) { return next.atlas != project.atlas || (lies(next) && !lies(project)); });
    ProgressParts parts([&](double fraction) {
        m_progress = fraction;
        return goOn(fraction);
    });
    auto pages = std::make_shared<const std::vector<Image>>(
        recomposite(*project.mesh, *project.atlas, m_kept.composition, project.layers,
                    project.texture.baseColour, m_kept.cache, parts.next(0.95)));
    const Progress reducing = parts.rest();
    m_kept.smaller = std::make_shared<const SmallerPages>(
        m_kept.smaller
            ? esm::smallerPages(*project.atlas, *pages, *m_kept.composition.pages, *m_kept.smaller, reducing)
            : esm::smallerPages(*project.atlas, *pages, reducing));
    m_kept.composition = {project.layers, project.texture.baseColour, pages};
}

TextureComposer::Composed TextureComposer::compositionOf(const Worker::Task& task) {
    using Milliseconds = std::chrono::duration<double, std::milli>;
    m_progress = 0;
    const Project& project = task.question;
    if (!project.atlas || project.layers.empty()) {
        m_kept = {};
        return {};
    }
    const auto start = std::chrono::steady_clock::now();
    try {
        keepPages(task);
    } catch (const std::bad_alloc&) {
        m_kept = {};
        throw InvalidModel("there is not enough memory; choose a smaller size of the atlas");
    }
    return {project.atlas,
            m_kept.composition.pages,
            m_kept.smaller,
            Milliseconds(std::chrono::steady_clock::now() - start).count(),
            {}};
}

} // namespace esm
