#include "app/editor/workers/texture_composer.h"

#include "core/support/errors.h"

#include <chrono>

namespace esm {

TextureComposer::TextureComposer(QObject* parent)
    : QObject(parent), m_worker([this](const Worker::Task& task) { return compositionOf(task); },
                                [this] { emit composed(); }) {}

TextureComposer::Pages TextureComposer::pages() const {
    return result().pages;
}

std::shared_ptr<const SmallerPages> TextureComposer::smallerPages() const {
    return result().smallerPages;
}

std::shared_ptr<const Atlas> TextureComposer::atlas() const {
    return result().atlas;
}

double TextureComposer::milliseconds() const {
    return result().milliseconds;
}

std::string TextureComposer::failure() const {
    return m_worker.outcome().failure;
}

TextureComposer::Composed TextureComposer::result() const {
    const Outcome<Composed> outcome = m_worker.outcome();
    return outcome.failure.empty() ? outcome.answer : Composed{};
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
    return {project.atlas, m_kept.composition.pages, m_kept.smaller,
            Milliseconds(std::chrono::steady_clock::now() - start).count()};
}

} // namespace esm
