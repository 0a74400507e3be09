#include "app/editor/workers/texture_composer.h"

#include <chrono>

namespace esm {

TextureComposer::TextureComposer(QObject* parent) : QObject(parent), m_thread([this] { work(); }) {}

TextureComposer::~TextureComposer() {
    m_requests.stop();
    m_thread.join();
}

void TextureComposer::compose(const Project& project) {
    m_requests.put({project, ++m_asked});
}

TextureComposer::Pages TextureComposer::pages() const {
    const std::lock_guard lock(m_mutex);
    return m_pages;
}

std::shared_ptr<const SmallerPages> TextureComposer::smallerPages() const {
    const std::lock_guard lock(m_mutex);
    return m_smallerPages;
}

std::shared_ptr<const Atlas> TextureComposer::atlas() const {
    const std::lock_guard lock(m_mutex);
    return m_atlas;
}

double TextureComposer::milliseconds() const {
    const std::lock_guard lock(m_mutex);
    return m_milliseconds;
}

std::string TextureComposer::failure() const {
    const std::lock_guard lock(m_mutex);
    return m_failure;
}

void TextureComposer::work() {
    while (const auto request = m_requests.take())
        compose(*request);
}

TextureComposer::Pages TextureComposer::pagesOf(const Project& project) {
    if (m_kept.mesh != project.mesh) m_kept = {project.mesh, nullptr, {}, nullptr, {}};
    if (m_kept.atlas != project.atlas) {
        m_kept.composition = {};
        m_kept.smaller = nullptr;
    }
    m_kept.atlas = project.atlas;
    const auto goOn = [&](double) {
        return !m_requests.isObsolete(
            [&](const Request& next) { return next.project.atlas != project.atlas; });
    };
    auto pages = std::make_shared<const std::vector<Image>>(
        recomposite(*project.mesh, *project.atlas, m_kept.composition, project.layers,
                    project.texture.baseColour, m_kept.cache, goOn));
    m_kept.smaller = std::make_shared<const SmallerPages>(
        m_kept.smaller ? esm::smallerPages(*project.atlas, *pages, *m_kept.composition.pages, *m_kept.smaller)
                       : esm::smallerPages(*project.atlas, *pages));
    m_kept.composition = {project.layers, project.texture.baseColour, pages};
    return pages;
}

void TextureComposer::compose(const Request& request) {
    const Project& project = request.project;
    const auto start = std::chrono::steady_clock::now();
    Pages pages;
    std::string failure;
    try {
        if (project.atlas && !project.layers.empty())
            pages = pagesOf(project);
        else
            m_kept = {};
    } catch (const Cancelled&) {
        return;
    } catch (const std::bad_alloc&) {
        m_kept = {};
        failure = "there is not enough memory; choose a smaller size of the atlas";
    } catch (const std::exception& error) {
        failure = error.what();
    }
    {
        const std::lock_guard lock(m_mutex);
        m_pages = std::move(pages);
        m_smallerPages = m_pages ? m_kept.smaller : nullptr;
        m_atlas = m_pages ? project.atlas : nullptr;
        m_failure = std::move(failure);
        m_milliseconds =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }
    m_finished = request.number; // before anyone hears of it
    emit composed();
}

} // namespace esm
