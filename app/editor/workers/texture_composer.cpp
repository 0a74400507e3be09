#include "app/editor/workers/texture_composer.h"

#include "core/support/errors.h"
#include "core/texture/layers/photo_in_motion.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace esm {

namespace {

/// Whether two layers lay the same colours and finish: a hidden one lays neither, wherever it is moved.
bool laysTheSame(const TextureLayer& a, const TextureLayer& b) {
    if (!isLaid(a) && !isLaid(b)) return true;
    return looksTheSame(a, b) && a.finish == b.finish;
}

} // namespace

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
           m_kept.base == project.texture.finish &&
           std::equal(kept.layers.begin(), kept.layers.end(), project.layers.begin(), project.layers.end(),
                      laysTheSame);
}

void TextureComposer::compose(const Project& project, std::optional<LayerId> moving) {
    Asked asked{project, std::nullopt};
    if (moving) {
        std::vector<TextureLayer>& layers = asked.project.layers;
        const auto place = std::find_if(layers.begin(), layers.end(),
                                        [&](const TextureLayer& layer) { return layer.id == *moving; });
        asked.moving = *place;
        place->visible = false;
    }
    m_worker.ask(std::move(asked));
}

/// Brings what is kept up to date with a project's layers.
void TextureComposer::keepPages(const Worker::Task& task) {
    const Project& project = task.question.project;
    if (m_kept.mesh != project.mesh) m_kept = {};
    m_kept.mesh = project.mesh;
    if (m_kept.atlas != project.atlas) {
        m_kept.composition = {};
        m_kept.smaller = nullptr;
        m_kept.masked = {};
        m_kept.finish = {};
    }
    m_kept.atlas = project.atlas;
    const Progress goOn = task.progress([&](const Asked& next) {
        return next.project.atlas != project.atlas || (lies(next.project) && !lies(project));
    });
    ProgressParts parts([&](double fraction) {
        m_progress = fraction;
        return goOn(fraction);
    });
    auto pages = std::make_shared<const TiledPages>(recomposite(
        *project.mesh, *project.atlas, m_kept.composition, project.layers, project.texture.baseColour,
        m_kept.cache, parts.next(hasFinish(project.layers, std::nullopt) ? 0.5 : 0.95)));
    auto smaller = halved(project, *pages, parts.next(0.05));
    FinishComposition finish = finishOf(project, parts.rest());
    // All together: stopped before, what is kept still belongs together.
    m_kept.smaller = std::move(smaller);
    m_kept.finish = std::move(finish);
    m_kept.base = project.texture.finish;
    m_kept.composition = {project.layers, project.texture.baseColour, pages};
}

FinishComposition TextureComposer::finishOf(const Project& project, const Progress& progress) {
    if (!hasFinish(project.layers, std::nullopt)) {
        m_kept.finishPictures = {};
        reportProgress(progress, 1);
        return {};
    }
    ProgressParts parts(progress);
    const FinishLayers layers =
        finishLayers(project.layers, project.texture.finish, m_kept.finishPictures, parts.next(0.3));
    return composedFinish(*project.mesh, *project.atlas, m_kept.finish, layers, m_kept.finishCache,
                          parts.rest());
}

std::shared_ptr<const SmallerPages> TextureComposer::halved(const Project& project, const TiledPages& pages,
                                                            const Progress& progress) {
    const Atlas& atlas = *project.atlas;
    if (usableLevels(atlas.options) == 0) {
        reportProgress(progress, 1);
        return std::make_shared<const SmallerPages>(pages.size());
    }
    ProgressParts parts(progress);
    HalvedPages before;
    if (m_kept.smaller && m_kept.composition.pages) before = {*m_kept.composition.pages, *m_kept.smaller};
    const auto owners = m_kept.cache.ownersOf(*project.mesh, atlas, parts.next(0.5));
    return std::make_shared<const SmallerPages>(smallerPages(atlas, *owners, pages, before, parts.rest()));
}

TextureComposer::Composed TextureComposer::compositionOf(const Worker::Task& task) {
    using Milliseconds = std::chrono::duration<double, std::milli>;
    m_progress = 0;
    const Project& project = task.question.project;
    if (!project.atlas || project.layers.empty()) {
        m_kept = {};
        return {};
    }
    const auto start = std::chrono::steady_clock::now();
    try {
        if (!isKept(task.question)) keepPages(task);
    } catch (const std::bad_alloc&) {
        m_kept = {};
        throw InvalidModel("there is not enough memory; choose a smaller size of the atlas");
    }
    Composed composed{project.atlas,
                      m_kept.composition.pages,
                      m_kept.smaller,
                      m_kept.finish.pages,
                      Milliseconds(std::chrono::steady_clock::now() - start).count(),
                      {}};
    if (task.question.moving) addMotion(task, composed);
    return composed;
}

/// While a photo moves, all around it stays as it was composed when it began to.
bool TextureComposer::isKept(const Asked& asked) const {
    return asked.moving && m_kept.mesh == asked.project.mesh && m_kept.atlas == asked.project.atlas &&
           lies(asked.project);
}

void TextureComposer::mask(const Project& project, const BrushStrokes& strokes, Composed& composed) {
    MaskedPages& masked = m_kept.masked;
    if (masked.of != composed.pages || !(masked.strokes == strokes)) {
        masked = {composed.pages, strokes, nullptr, nullptr};
        masked.pages = std::make_shared<const TiledPages>(
            maskedPages(*project.mesh, *project.atlas, *composed.pages, strokes, m_kept.cache));
        masked.smaller = halved(project, *masked.pages, {});
    }
    composed.pages = masked.pages;
    composed.smallerPages = masked.smaller;
    composed.isMasked = true;
}

void TextureComposer::addMotion(const Worker::Task& task, Composed& composed) {
    const Project& project = task.question.project;
    const TextureLayer& layer = *task.question.moving;
    composed.moving = layer.id;
    if (!layer.strokes.empty()) mask(project, layer.strokes, composed);
    if (layer.blending == Blending::MultiBand)
        composed.bands = std::make_shared<const Image>(
            bandsInMotion({*project.mesh, *project.atlas, *composed.pages}, layer, m_kept.cache));
}

} // namespace esm
