#include "app/editor/workers/texture_composer.h"

#include "core/support/errors.h"

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

/// Brings what is kept up to date with a project's layers.
void TextureComposer::keepPages(const Worker::Task& task) {
    const Project& project = task.question;
    if (m_kept.mesh != project.mesh) m_kept = {project.mesh, nullptr, {}, nullptr, {}};
    if (m_kept.atlas != project.atlas) {
        m_kept.composition = {};
        m_kept.smaller = nullptr;
    }
    m_kept.atlas = project.atlas;
    const Progress goOn = task.progress([&](const Project& next) { return next.atlas != project.atlas; });
    auto pages = std::make_shared<const std::vector<Image>>(
        recomposite(*project.mesh, *project.atlas, m_kept.composition, project.layers,
                    project.texture.baseColour, m_kept.cache, goOn));
    m_kept.smaller = std::make_shared<const SmallerPages>(
        m_kept.smaller ? esm::smallerPages(*project.atlas, *pages, *m_kept.composition.pages, *m_kept.smaller)
                       : esm::smallerPages(*project.atlas, *pages));
    m_kept.composition = {project.layers, project.texture.baseColour, pages};
}

TextureComposer::Composed TextureComposer::compositionOf(const Worker::Task& task) {
    using Milliseconds = std::chrono::duration<double, std::milli>;
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
