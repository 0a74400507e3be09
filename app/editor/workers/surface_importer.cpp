#include "app/editor/workers/surface_importer.h"

namespace esm {

namespace {

constexpr std::chrono::milliseconds settling{40};

/// Looks at a soup, and not again where only unit or axis are others. Of the worker's thread alone.
class SoupReader {
public:
    SoupReader(std::shared_ptr<const PolygonSoup> soup, std::shared_ptr<const ImportedSurface> found)
        : m_soup(std::move(soup)), m_surface(std::move(found)) {}

    SurfaceImporter::Answer answer(const ImportQuestion& question, const Progress& progress) {
        if (m_options != question.options) {
            m_surface =
                std::make_shared<const ImportedSurface>(importedSurface(*m_soup, question.options, progress));
            m_options = question.options;
        }
        return std::make_shared<const ImportAnswer>(
            ImportAnswer{m_surface, importPreview(*m_surface, question.unit, question.up)});
    }

private:
    std::shared_ptr<const PolygonSoup> m_soup;
    RepairOptions m_options; ///< of the surface
    std::shared_ptr<const ImportedSurface> m_surface;
};

} // namespace

SurfaceImporter::SurfaceImporter(std::shared_ptr<const PolygonSoup> soup,
                                 std::shared_ptr<const ImportedSurface> found, QObject* parent)
    : DialogWorker([reader = std::make_shared<SoupReader>(std::move(soup), std::move(found))](
                       const auto& task) { return reader->answer(task.question, task.progress()); },
                   settling, parent) {}

} // namespace esm
