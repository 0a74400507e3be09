#include "app/editor/tools/landmarking.h"

#include <utility>

namespace esm {

namespace {

constexpr std::size_t fewestPairs = 4; ///< that a pose takes

} // namespace

Projector placedBy(const PoseFit& fit, const Projector& before) {
    Projector placed = before;
    placed.kind = fit.projector.kind;
    placed.pose = fit.projector.pose;
    placed.fieldOfView = fit.projector.fieldOfView;
    placed.intrinsics = fit.projector.intrinsics;
    placed.areIntrinsicsFound = fit.projector.areIntrinsicsFound;
    return placed;
}

Landmarking::Landmarking(Document& document, Selection& selection, QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection) {
    connect(&selection, &Selection::changed, this, &Landmarking::follow);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.isOfHistory || change.mesh) m_before.reset();
        if (change.layers || change.landmarks || change.mesh) follow();
    });
    connect(&m_finder, &PoseFinder::answered, this, &Landmarking::takeAnswer);
    connect(&m_refiner, &PlacementRefiner::answered, this, &Landmarking::takeRefinement);
    follow();
}

const TextureLayer* Landmarking::layer() const {
    const TextureLayer* selected = m_selection.selectedLayer();
    return selected && selected->photo ? selected : nullptr;
}

const std::vector<LandmarkPair>& Landmarking::pairs() const {
    static const std::vector<LandmarkPair> none;
    return layer() ? layer()->landmarks : none;
}

void Landmarking::follow() {
    if (m_photo != m_selection.photo()) {
        m_photo = m_selection.photo();
        m_selected.reset();
        m_half = {};
    }
    if (m_selected && *m_selected >= pairs().size()) m_selected.reset();
    if (layer() && pairs().size() >= fewestPairs && !(m_asked && *m_asked == question())) {
        m_asked = question();
        m_finder.find(*m_asked);
    }
    emit changed();
}

/// A camera that was measured stays as it is; a lens that was straightened leaves one.
PoseQuestion Landmarking::question() const {
    const Image& picture = *pictureOf(*layer());
    PhotoCamera camera{{picture.width, picture.height}, {}};
    if (!layer()->projector.areIntrinsicsFound) camera.intrinsics = layer()->projector.intrinsics;
    if (!camera.intrinsics && layer()->preparation.lens)
        camera.intrinsics = layer()->preparation.lens->camera;
    return {pairs(), camera};
}

const PoseAnswer* Landmarking::answer() const {
    return m_answer && layer() && m_answer->question == question() ? m_answer.get() : nullptr;
}

const PoseFit* Landmarking::fit() const {
    const PoseAnswer* found = answer();
    return found && found->fit ? &*found->fit : nullptr;
}

QString Landmarking::failure() const {
    const PoseAnswer* found = answer();
    QString failure = found ? QString::fromStdString(found->failure) : QString();
    if (!failure.isEmpty()) failure[0] = failure[0].toUpper();
    return failure;
}

bool Landmarking::isElsewhere() const {
    return fit() && !(placedBy(*fit(), layer()->projector) == layer()->projector);
}

void Landmarking::select(std::optional<std::size_t> pair) {
    if (pair && *pair >= pairs().size()) pair.reset();
    if (pair == m_selected) return;
    m_selected = pair;
    emit changed();
}

void Landmarking::pickPixel(const Eigen::Vector2d& pixel) {
    if (!layer()) return;
    m_half.photo = pixel;
    completeHalf();
}

void Landmarking::pickPoint(const Eigen::Vector3d& point) {
    if (!layer()) return;
    m_half.organ = point;
    completeHalf();
}

void Landmarking::completeHalf() {
    if (!m_half.photo || !m_half.organ) return emit changed();
    const LandmarkPair pair{*m_half.photo, *m_half.organ};
    m_half = {};
    m_selected.reset();
    finishMove();
    edit(tr("Add landmark"), [&](std::vector<LandmarkPair>& pairs) { pairs.push_back(pair); });
    finishMove();
}

void Landmarking::giveUpHalf() {
    if (!m_half.isBegun()) return;
    m_half = {};
    emit changed();
}

void Landmarking::finishMove() {
    m_before.reset();
    ++m_gesture;
}

void Landmarking::beginMove() {
    if (!m_before) m_before = Before{layer()->id, pairs(), layer()->projector};
}

/// The step of the move comes to nothing and goes: a pose that is still being sought joins it no more.
void Landmarking::dropMove() {
    if (!m_before) return;
    const Before before = *m_before;
    m_wanted.reset();
    if (findPart(m_document.project().layers, before.photo))
        m_document.edit(tr("Move landmark"),
                        [&](Project& project) {
                            TextureLayer& moved = partOf(project.layers, before.photo);
                            moved.landmarks = before.pairs;
                            moved.projector = before.projector;
                        },
                        {EditKind::Landmarks, before.photo, static_cast<std::uint64_t>(m_gesture)});
    finishMove();
}

void Landmarking::movePixel(std::size_t pair, const Eigen::Vector2d& pixel) {
    if (pair == pairs().size() && m_half.photo) return pickPixel(pixel);
    if (pair >= pairs().size()) return;
    m_selected = pair;
    beginMove();
    edit(tr("Move landmark"), [&](std::vector<LandmarkPair>& pairs) { pairs[pair].photo = pixel; });
}

void Landmarking::movePoint(std::size_t pair, const Eigen::Vector3d& point) {
    if (pair == pairs().size() && m_half.organ) return pickPoint(point);
    if (pair >= pairs().size()) return;
    m_selected = pair;
    beginMove();
    edit(tr("Move landmark"), [&](std::vector<LandmarkPair>& pairs) { pairs[pair].organ = point; });
}

void Landmarking::remove(std::size_t pair) {
    if (pair >= pairs().size()) return;
    finishMove();
    m_selected.reset();
    edit(tr("Remove landmark"), [&](std::vector<LandmarkPair>& pairs) {
        pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(pair));
    });
    finishMove();
}

void Landmarking::replace(std::vector<LandmarkPair> pairs) {
    finishMove();
    m_half = {};
    edit(tr("Load landmarks"), [&](std::vector<LandmarkPair>& now) { now = pairs; });
    finishMove();
}

/// The pose comes a moment later and joins the step by its key, wherever no other step came between.
void Landmarking::edit(const QString& text, const std::function<void(std::vector<LandmarkPair>&)>& change) {
    if (!layer()) return;
    const LayerId photo = layer()->id;
    std::vector<LandmarkPair> after = pairs();
    change(after);
    m_wanted = Wanted{after, text, {EditKind::Landmarks, photo, static_cast<std::uint64_t>(m_gesture)}};
    m_document.edit(
        text, [&](Project& project) { partOf(project.layers, photo).landmarks = after; }, m_wanted->mergeKey);
}

void Landmarking::takeAnswer() {
    m_answer = m_finder.answer();
    if (answer() && m_wanted && m_wanted->pairs == pairs()) {
        const Wanted wanted = *std::exchange(m_wanted, std::nullopt);
        if (fit()) placeBy(*fit(), wanted.text, wanted.mergeKey);
    }
    emit changed();
}

void Landmarking::place() {
    if (fit()) placeBy(*fit(), tr("Place photo by landmarks"), {});
}

void Landmarking::placeBy(const PoseFit& fit, const QString& text, const MergeKey& mergeKey) {
    const Projector placed = placedBy(fit, layer()->projector);
    const LayerId photo = layer()->id;
    m_document.edit(
        text, [&](Project& project) { partOf(project.layers, photo).projector = placed; }, mergeKey);
}

std::vector<TextureLayer> Landmarking::others() const {
    std::vector<TextureLayer> others;
    if (!layer()) return others;
    for (const TextureLayer& other : m_document.project().layers)
        if (other.id != layer()->id && isShown(other)) others.push_back(other);
    return others;
}

void Landmarking::refine() {
    if (!mayRefine()) return;
    m_refining = std::pair(layer()->id, layer()->projector);
    m_inVain.reset();
    m_refiner.refine({m_document.project().mesh, others(), *layer()});
    emit changed();
}

/// An answer for a photo that was moved meanwhile, or is selected no longer, is dropped.
void Landmarking::takeRefinement() {
    if (m_refiner.isWorking()) return; // another one was asked for meanwhile
    const auto asked = std::exchange(m_refining, std::nullopt);
    if (asked && layer() && asked == std::pair(layer()->id, layer()->projector)) {
        m_refinement = m_refiner.answer();
        if (!m_refinement) m_inVain = asked;
        if (m_refinement)
            m_document.edit(tr("Refine placement"), [&](Project& project) {
                partOf(project.layers, asked->first).projector = m_refinement->projector;
            });
    }
    emit changed();
}

const PoseRefinement* Landmarking::refinement() const {
    return m_refinement && layer() && layer()->projector == m_refinement->projector ? &*m_refinement
                                                                                    : nullptr;
}

bool Landmarking::wasRefinedInVain() const {
    return m_inVain && layer() && m_inVain == std::pair(layer()->id, layer()->projector);
}

} // namespace esm
