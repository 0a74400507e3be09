#include "app/editor/document/document.h"
#include "app/editor/edits/photo_edits.h"
#include "core/authoring/regions.h"
#include "core/samples/samples.h"
#include "core/surface/surface_query.h"

#include <gtest/gtest.h>
#include <QSignalSpy>

using namespace esm;

namespace {

void setMass(Document& document, double mass, EditKind kind = EditKind::Alone) {
    document.edit(
        "mass", [mass](Project& project) { project.base.mass = mass; }, MergeKey(kind));
}

/// Adds a region, and gives it.
RegionId added(Document& document) {
    const RegionId id = document.newRegionId();
    document.edit("add", [&](Project& project) { addRegion(project, id, Eigen::Vector3d::Zero()); });
    return id;
}

Image blankPhoto(int width, int height) {
    Image photo;
    photo.width = width;
    photo.height = height;
    photo.pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    return photo;
}

} // namespace

TEST(Document, MergesADragIntoOneStep) {
    Document document(makeSample("tube"));
    const Project before = document.project();
    for (const double mass : {0.02, 0.03, 0.04})
        setMass(document, mass, EditKind::BaseTissue);
    EXPECT_EQ(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    EXPECT_FALSE(difference(before, document.project()).any());
    document.undoStack()->redo();
    EXPECT_EQ(document.project().base.mass, 0.04);
}

TEST(Document, GoesToAnyStepAsOneChange) {
    Document document(makeSample("tube"));
    for (const double mass : {0.02, 0.03, 0.04, 0.05})
        setMass(document, mass);
    const RegionId region = added(document);
    std::vector<Change> changes;
    int steps = 0;
    QObject::connect(&document, &Document::changed, [&](const Change& change) { changes.push_back(change); });
    QObject::connect(&document, &Document::stepped, [&] { ++steps; });
    document.goTo(1);
    EXPECT_EQ(document.project().base.mass, 0.02);
    EXPECT_EQ(findPart(document.project().regions, region), nullptr);
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_TRUE(changes[0].isOfHistory);
    EXPECT_TRUE(changes[0].tissue);
    EXPECT_TRUE(changes[0].regions);
    document.goTo(5);
    EXPECT_EQ(document.project().base.mass, 0.05);
    EXPECT_NE(findPart(document.project().regions, region), nullptr);
    document.goTo(5);
    EXPECT_EQ(changes.size(), 2U);
    EXPECT_EQ(steps, 2);
    EXPECT_EQ(document.undoStack()->index(), 5);
}

TEST(Document, TellsOfEachStepGoneToEvenWhereNothingIsOtherThere) {
    Document document(makeSample("tube"));
    const double first = document.project().base.mass;
    for (const double mass : {2 * first, first})
        setMass(document, mass);
    QSignalSpy changed(&document, &Document::changed), stepped(&document, &Document::stepped);
    document.goTo(0);
    EXPECT_EQ(changed.count(), 0);
    EXPECT_EQ(stepped.count(), 1);
    EXPECT_EQ(document.undoStack()->index(), 0);
}

TEST(Document, TellsWhenItGoesToOrFromWhatIsSaved) {
    Document document(makeSample("tube"));
    setMass(document, 0.02);
    document.markSaved("tube.esm", document.project());
    setMass(document, 0.03);
    QSignalSpy told(&document, &Document::titleChanged);
    document.goTo(1);
    EXPECT_EQ(told.count(), 1);
    EXPECT_FALSE(document.isModified());
    document.goTo(0);
    EXPECT_EQ(told.count(), 2);
    EXPECT_TRUE(document.isModified());
}

TEST(Document, TellsWhatIsUndoneFromWhatIsEdited) {
    Document document(makeSample("tube"));
    std::vector<bool> ofHistory;
    QObject::connect(&document, &Document::changed,
                     [&](const Change& change) { ofHistory.push_back(change.isOfHistory); });
    setMass(document, 0.02);
    document.undoStack()->undo();
    document.undoStack()->redo();
    setMass(document, 0.03);
    EXPECT_EQ(ofHistory, (std::vector<bool>{false, true, true, false}));
}

TEST(Document, StartsANewStepAfterADrag) {
    Document document(makeSample("tube"));
    setMass(document, 0.02, EditKind::BaseTissue);
    document.finishGesture();
    setMass(document, 0.03, EditKind::BaseTissue);
    EXPECT_EQ(document.undoStack()->count(), 2);
}

TEST(Document, DropsEditsThatChangeNothing) {
    Document document(makeSample("tube"));
    const double mass = document.project().base.mass;
    QSignalSpy changed(&document, &Document::changed);
    setMass(document, mass);
    EXPECT_EQ(document.undoStack()->count(), 0);
    EXPECT_EQ(changed.count(), 0);
    setMass(document, 2 * mass, EditKind::BaseTissue);
    setMass(document, mass, EditKind::BaseTissue);
    EXPECT_EQ(document.undoStack()->count(), 0);
    EXPECT_FALSE(document.isModified());
}

TEST(Document, SaysWhatChanged) {
    const Project before = makeSample("tube");
    const auto changed = [&](const std::function<void(Project&)>& edit) {
        Project after = before;
        edit(after);
        return difference(before, after);
    };
    EXPECT_TRUE(changed([](Project& p) { p.name = "x"; }).name);
    EXPECT_TRUE(changed([](Project& p) { p.base.viscosity += 1; }).tissue);
    EXPECT_TRUE(
        changed([](Project& p) { addRegion(p, nextId(p.regions), Eigen::Vector3d::Zero()); }).regions);
    const auto withRegion = [&](const std::function<void(Region&)>& edit) {
        Project one = before;
        addRegion(one, nextId(one.regions), Eigen::Vector3d::Zero());
        Project other = one;
        edit(other.regions.back());
        return difference(one, other);
    };
    EXPECT_TRUE(withRegion([](Region& r) { r.held.mass = 1; }).model());
    EXPECT_TRUE(withRegion([](Region& r) { r.name = "x"; }).regions);
    EXPECT_FALSE(withRegion([](Region& r) { r.name = "x"; }).model());
    EXPECT_FALSE(withRegion([](Region& r) { r.colour = {1, 2, 3}; }).model());
    EXPECT_TRUE(changed([](Project& p) { p.scene.gravity.y() = -9.81; }).scene);
    EXPECT_TRUE(changed([](Project& p) { p.texture.atlas.size = 512; }).texture);
    EXPECT_TRUE(changed([](Project& p) { p.texture.atlas.texelsPerMetre = 512; }).texture);
    EXPECT_TRUE(changed([](Project& p) { p.mesh = std::make_shared<TriangleMesh>(*p.mesh); }).mesh);
    EXPECT_FALSE(changed([](Project&) {}).any());
}

TEST(Document, TellsLandmarksFromWhatLiesOnTheOrgan) {
    Project before = makeSample("liver");
    before.layers.resize(1);
    Project after = before;
    after.layers[0].landmarks.push_back({{1, 2}, {3, 4, 5}});
    EXPECT_TRUE(difference(before, after).landmarks);
    EXPECT_TRUE(difference(before, after).any());
    EXPECT_FALSE(difference(before, after).picture());
}

TEST(Document, ForgetsItsStepsWithAnotherProject) {
    Document document(makeSample("tube"));
    setMass(document, 0.5);
    document.replace(makeSample("uterus"), std::nullopt);
    EXPECT_FALSE(document.undoStack()->canUndo());
    EXPECT_FALSE(document.isModified());
}

TEST(Document, IsSavedOnlyAsTheProjectThatWasWritten) {
    Document document(makeSample("tube"));
    setMass(document, 0.5);
    const Project written = document.project();
    setMass(document, 0.75);
    document.markSaved("tube.esm", written);
    EXPECT_TRUE(document.isModified());
    document.markSaved("tube.esm", document.project());
    EXPECT_FALSE(document.isModified());
}

TEST(Document, IsUnsavedWhereItsProjectLiesInNoFile) {
    Document document(makeSample("tube"));
    document.replace(makeSample("uterus"), std::nullopt, Origin::Unsaved);
    EXPECT_TRUE(document.isModified());
    setMass(document, 0.5);
    document.undoStack()->undo();
    EXPECT_TRUE(document.isModified());
}

TEST(Document, ComesBackWithItsUndoList) {
    Document document(makeSample("tube"));
    const RegionId first = added(document);
    setMass(document, 0.5);
    document.undoStack()->setClean();
    const RegionId last = added(document);
    document.undoStack()->setIndex(1);

    Document again(makeSample("uterus"));
    setMass(again, 0.25);
    QSignalSpy steps(&again, &Document::stepped), replacements(&again, &Document::replaced);
    again.restore(document.state());
    EXPECT_EQ(steps.size(), 0) << "to come back is no step";
    EXPECT_EQ(replacements.size(), 1);
    EXPECT_EQ(again.project(), document.project());
    EXPECT_EQ(again.project().regions.back().id, first);
    EXPECT_TRUE(again.isModified());
    again.undoStack()->redo();
    EXPECT_FALSE(again.isModified());
    EXPECT_EQ(again.project().base.mass, 0.5);
    again.undoStack()->redo();
    EXPECT_EQ(again.project().regions.back().id, last);
    EXPECT_GT(again.newRegionId().number, last.number) << "none is given twice";
    again.undoStack()->setIndex(0);
    EXPECT_EQ(again.project(), *document.state().base);
}

TEST(RegionEdits, KeepTheWholeOrganBeneath) {
    Project project = makeSample("tube");
    project.regions.clear();
    const RegionId lower{7}, upper{8}, whole{9};
    addRegion(project, lower, Eigen::Vector3d::Zero());
    setSystem(project, whole, std::make_shared<FuzzySystem>());
    ASSERT_EQ(wholeOrganRegion(project), &project.regions[0]);
    EXPECT_EQ(project.regions[0].id, whole);
    EXPECT_FALSE(canMoveRegion(project, whole, 1));
    EXPECT_FALSE(canMoveRegion(project, lower, -1));
    addRegion(project, upper, Eigen::Vector3d::Zero());
    ASSERT_TRUE(canMoveRegion(project, lower, 1));
    moveRegion(project, lower, 1);
    EXPECT_EQ(project.regions[2].id, lower);
    EXPECT_NE(project.regions[1].colour, project.regions[2].colour);
}

TEST(PhotoEdits, AProjectorStandsBetweenTheEyeAndTheOrgan) {
    const Project project = makeSample("liver");
    const auto box = boundingBox(project.mesh->vertices);
    const Image photo = blankPhoto(200, 100);
    for (const auto view : {StandardView::Front, StandardView::Left, StandardView::Top}) {
        const Camera camera = framedCamera(box, view, 1.5);
        const Projector projector = projectorFromCamera(camera, photo, *project.mesh);
        const Eigen::Vector3d towards = (camera.target - camera.eye).normalized();
        EXPECT_LT((projector.pose.linear() * -Eigen::Vector3d::UnitZ() - towards).norm(), 1e-9);
        EXPECT_NEAR(projector.pose.linear().determinant(), 1, 1e-9);
        EXPECT_DOUBLE_EQ(projector.width, 2 * projector.height);
        for (const auto& vertex : project.mesh->vertices)
            EXPECT_GE((vertex - projector.pose.translation()).dot(towards), 0);
        const double depth = (projector.pose.translation() - camera.eye).dot(towards);
        EXPECT_GT(depth, 0);
    }
}

TEST(PhotoEdits, APerspectivePhotoFromTheCameraShowsWhatIsSeen) {
    const Project project = makeSample("liver");
    const Image photo = blankPhoto(160, 90);
    Projector before;
    before.kind = ProjectorKind::Perspective;
    before.falloff = true;
    before.intrinsics = Intrinsics{1, 1, 0, 0};
    const double aspect = 16.0 / 9;
    const Camera camera =
        orbited(framedCamera(boundingBox(project.mesh->vertices), StandardView::Left, aspect), 0.3, 0.4);
    const Projector projector = aimedByCamera(before, camera, photo, *project.mesh);
    EXPECT_TRUE(projector.falloff);
    for (std::size_t i = 0; i < project.mesh->vertices.size(); i += 97) {
        const Eigen::Vector3d& vertex = project.mesh->vertices[i];
        const auto seen = picturePoint(camera, vertex, aspect);
        const auto projected = esm::project(projector, {160, 90}, vertex);
        EXPECT_NEAR(160 * seen->x(), projected->x(), 1e-6);
        EXPECT_NEAR(90 * seen->y(), projected->y(), 1e-6);
    }
}

TEST(PhotoEdits, WhoLooksThroughAPhotoSeesItsPixelsEvenlyInTheMiddle) {
    const Project project = makeSample("liver");
    const PhotoSize photo{160, 90};
    const auto box = boundingBox(project.mesh->vertices);
    Projector parallel =
        projectorFromCamera(framedCamera(box, StandardView::Front, 1.5), blankPhoto(160, 90), *project.mesh);
    Projector perspective = parallel;
    perspective.kind = ProjectorKind::Perspective;
    perspective.pose.translation() += 0.2 * perspective.pose.linear().col(2);
    Projector measured = perspective;
    measured.intrinsics = Intrinsics{150, 130, 95, 40};
    for (const Projector& projector : {parallel, perspective, measured})
        for (const double aspect : {1.0, 2.5}) {
            const Camera camera = cameraThrough(projector, photo, *project.mesh, aspect);
            const auto corners = photoCorners(projector, photo, projector.isParallel() ? 0 : 0.1);
            const auto low = picturePoint(camera, corners[0], aspect),
                       high = picturePoint(camera, corners[2], aspect);
            ASSERT_TRUE(low && high);
            EXPECT_TRUE((*low + *high).isApprox(Eigen::Vector2d(1, 1), 1e-9)) << "in the middle";
            const Eigen::Vector2d share = (*high - *low).cwiseAbs();
            EXPECT_NEAR(share.maxCoeff(), 0.8, 1e-9);
            for (std::size_t i = 0; i < project.mesh->vertices.size(); i += 97) {
                const Eigen::Vector3d& vertex = project.mesh->vertices[i];
                const auto seen = picturePoint(camera, vertex, aspect);
                const auto projected = esm::project(projector, photo, vertex);
                const Eigen::Vector2d inPhoto(projected->x() / photo.width, projected->y() / photo.height);
                const Eigen::Vector2d expected =
                    Eigen::Vector2d(0.5, 0.5) + (inPhoto - Eigen::Vector2d(0.5, 0.5)).cwiseProduct(share);
                EXPECT_TRUE(seen->isApprox(expected, 1e-6));
            }
        }
}

TEST(PhotoEdits, AProjectorOfAnotherKindLiesInTheSamePlace) {
    const Project project = makeSample("liver");
    const Image photo = blankPhoto(160, 80);
    const Camera camera = framedCamera(boundingBox(project.mesh->vertices), StandardView::Front, 2);
    const Projector parallel = projectorFromCamera(camera, photo, *project.mesh);
    const Projector perspective = ofKind(ProjectorKind::Perspective, parallel, photo, *project.mesh);
    const Projector back = ofKind(ProjectorKind::Parallel, perspective, photo, *project.mesh);
    const Eigen::Vector3d sight = -parallel.pose.linear().col(2);
    const auto hit = SurfaceQuery(project.mesh->vertices, project.mesh->triangles)
                         .firstHit({parallel.pose.translation(), sight});
    ASSERT_TRUE(hit);
    const Eigen::Vector3d middle = parallel.pose.translation() + hit->distance * sight;
    const Eigen::Vector3d corner =
        middle + parallel.pose.linear() * Eigen::Vector3d(parallel.width / 2, -parallel.height / 2, 0);
    for (const Projector& projector : {parallel, perspective, back}) {
        EXPECT_TRUE(
            esm::project(projector, {160, 80}, middle)->head<2>().isApprox(Eigen::Vector2d(80, 40), 1e-6));
        EXPECT_TRUE(
            esm::project(projector, {160, 80}, corner)->head<2>().isApprox(Eigen::Vector2d(160, 80), 1e-6));
    }
}
