#include "tests/app/editor/document/random_edits.h"

#include "app/editor/document/journal_store.h"
#include "core/authoring/layers.h"
#include "core/authoring/packing.h"
#include "core/authoring/regions.h"
#include "core/samples/samples.h"

#include <QUndoStack>

namespace esm {

Project projectToEdit() {
    Project project = makeSample("tube");
    addRegion(project, nextId(project.regions), project.mesh->vertices.front());
    AtlasOptions options;
    options.size = 512;
    addPaintLayer(project, nextId(project.layers),
                  std::make_shared<const Atlas>(packFitting(*project.mesh, options)));
    return project;
}

const Region* RandomEdits::anyRegion() {
    const auto& regions = m_document.project().regions;
    return regions.empty() ? nullptr : &regions[below(static_cast<std::uint32_t>(regions.size()))];
}

void RandomEdits::next() {
    if (m_dragLeft > 0) {
        --m_dragLeft;
        return slide();
    }
    if (m_isPainting || below(6) == 0) return paint();
    switch (below(8)) {
    case 0:
    case 1:
        if (below(4) == 0) m_dragLeft = below(m_longestDrag);
        return slide();
    case 2:
    case 3:
        return changeRegion();
    case 4:
        return addOrRemoveRegion();
    case 5:
        return rename();
    case 6:
        return m_document.finishGesture();
    default:
        return walk();
    }
}

void RandomEdits::slide() {
    const double mass = 0.1 + share();
    m_document.edit(
        "Change mass", [mass](Project& project) { project.base.mass = mass; },
        MergeKey(EditKind::BaseTissue));
}

void RandomEdits::changeRegion() {
    const Region* region = anyRegion();
    if (!region) return;
    const RegionId id = region->id;
    const double constant = 1 + 50 * share();
    m_document.edit("Hold a value",
                    [&](Project& project) { partOf(project.regions, id).held.springConstant = constant; },
                    {EditKind::HeldValue, id});
}

void RandomEdits::addOrRemoveRegion() {
    const Region* region = anyRegion();
    if (region && m_document.project().regions.size() > 4) {
        const RegionId id = region->id;
        return m_document.edit("Remove region", [&](Project& project) { removeRegion(project, id); });
    }
    const auto& vertices = m_document.project().mesh->vertices;
    const Eigen::Vector3d centre = vertices[below(static_cast<std::uint32_t>(vertices.size()))];
    const RegionId id = m_document.newRegionId();
    m_document.edit("Add region", [&](Project& project) { addRegion(project, id, centre); });
}

void RandomEdits::paint() {
    const auto& layers = m_document.project().layers;
    if (layers.empty()) {
        m_isPainting = false;
        return;
    }
    const auto& vertices = m_document.project().mesh->vertices;
    const BrushPoint point{vertices[below(static_cast<std::uint32_t>(vertices.size()))],
                           Eigen::Vector3d::UnitZ()};
    const BrushTouch touch{point, below(2) != 0 ? std::optional(0.1 * below(11)) : std::nullopt};
    if (!m_isPainting) {
        m_selection.setPhoto(layers.front().id);
        m_painting.begin(touch);
    } else {
        m_painting.goOn({touch});
    }
    m_isPainting = below(6) != 0;
    if (!m_isPainting) m_painting.finish();
}

void RandomEdits::walk() {
    QUndoStack& stack = *m_document.undoStack();
    const int far = 1 + static_cast<int>(below(3));
    stack.setIndex(below(2) == 0 ? std::max(0, stack.index() - far)
                                 : std::min(stack.count(), stack.index() + far));
}

void RandomEdits::rename() {
    const std::string name = "organ " + std::to_string(below(1000));
    m_document.edit("Rename", [&](Project& project) { project.name = name; });
}

std::string DocumentDigests::of(const std::shared_ptr<const Project>& project) {
    std::string& digest = m_projects[project];
    if (!digest.empty()) return digest;
    const ProjectContent content = contentOf(*project);
    std::string text = manifestText(content.manifest);
    for (const ContentPiece& piece : content.pieces) {
        std::string& hash = m_pieces[{piece.source, piece.entry}];
        if (hash.empty()) hash = hashOf(piece.bytes());
        text += piece.entry + hash;
    }
    for (const Region& region : project->regions)
        text += " r" + std::to_string(region.id.number);
    for (const TextureLayer& layer : project->layers)
        text += " l" + std::to_string(layer.id.number);
    return digest = hashOf(Bytes(text.begin(), text.end()));
}

std::string DocumentDigests::of(const DocumentState& state) {
    std::string text = std::to_string(state.index) + ' ' + of(state.base);
    for (const DocumentStep& step : state.steps)
        text += '\n' + step.text.toStdString() + ' ' + of(step.after);
    return hashOf(Bytes(text.begin(), text.end()));
}

} // namespace esm
