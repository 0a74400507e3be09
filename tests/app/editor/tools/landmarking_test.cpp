#include "app/editor/tools/landmarking.h"
#include "app/editor/workers/preview.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/exchange/project/pairs_file.h"
#include "core/samples/samples.h"
#include "core/surface/surface_query.h"
#include "tests/app/editor_driver.h"
#include "tests/support/known_camera.h"
#include "tests/support/temporary_folder.h"
#include "widgets/view/photo_view.h"

#include <gtest/gtest.h>
#include <QListWidget>

using namespace esm;

namespace {

/// A camera before the liver, and points of the liver that lie in no plane.
class LandmarkingTest : public testing::Test {
protected:
    LandmarkingTest() : document(withPhoto()), selection(document), landmarking(document, selection) {
        selection.setPhoto(document.project().layers[0].id);
        truth.kind = ProjectorKind::Perspective;
        truth.fieldOfView = 40;
        const Eigen::AlignedBox3d box = boundingBox(document.project().mesh->vertices);
        truth.pose.translation() = box.center() + Eigen::Vector3d(0, 0, 1.5 * box.diagonal().norm());
    }

    static Project withPhoto() {
        Project project = makeSample("liver");
        project.layers.resize(1);
        project.layers[0].photo = makeSamplePhoto("serosa");
        project.layers[0].landmarks.clear();
        project.layers[0].projector.falloff = true;
        return project;
    }

    PhotoSize size() const {
        const Image& image = document.project().layers[0].photo->image;
        return {image.width, image.height};
    }
    Eigen::Vector3d vertex(std::size_t i) const {
        const auto& vertices = document.project().mesh->vertices;
        return vertices[(i * 7919) % vertices.size()];
    }
    Eigen::Vector2d seen(const Eigen::Vector3d& point) const {
        return esm::project(truth, size(), point)->head<2>();
    }
    void setPair(std::size_t i) {
        landmarking.pickPixel(seen(vertex(i)));
        landmarking.pickPoint(vertex(i));
    }
    const Projector& placed() const { return document.project().layers[0].projector; }
    double poseError() const { return (placed().pose.translation() - truth.pose.translation()).norm(); }

    Document document;
    Selection selection;
    Landmarking landmarking;
    Projector truth;
};

TEST_F(LandmarkingTest, PlacesThePhotoFromFourPairsOn) {
    const Projector before = placed();
    for (std::size_t i = 0; i < 3; ++i)
        setPair(i);
    ESM_EVENTUALLY(!landmarking.isSeeking());
    EXPECT_TRUE(placed() == before) << "three do not place it";
    EXPECT_EQ(landmarking.fit(), nullptr);
    for (std::size_t i = 3; i < 8; ++i)
        setPair(i);
    ESM_EVENTUALLY(landmarking.fit() && poseError() < 1e-4);
    EXPECT_EQ(landmarking.fit()->focalLength, PartSource::Found);
    EXPECT_EQ(placed().kind, ProjectorKind::Perspective);
    EXPECT_NEAR(placed().fieldOfView, 40, 0.01);
    EXPECT_TRUE(placed().falloff) << "of all else the projector stays as it was";
    EXPECT_LT(landmarking.fit()->error, 0.1);
    EXPECT_FALSE(landmarking.isElsewhere());
}

TEST_F(LandmarkingTest, EveryPairIsOneStepWithWhatComesOfIt) {
    for (std::size_t i = 0; i < 6; ++i)
        setPair(i);
    ESM_EVENTUALLY(landmarking.fit() && !landmarking.isElsewhere());
    EXPECT_EQ(document.undoStack()->count(), 6);
    const Projector bySix = placed();
    setPair(6);
    ESM_EVENTUALLY(landmarking.fit() && !landmarking.isElsewhere());
    EXPECT_EQ(document.undoStack()->count(), 7);
    document.undoStack()->undo();
    EXPECT_EQ(landmarking.pairs().size(), 6U);
    EXPECT_TRUE(placed() == bySix);
    ESM_EVENTUALLY(!landmarking.isSeeking());
    EXPECT_TRUE(document.undoStack()->canRedo()) << "what is undone is not placed anew";
    document.undoStack()->redo();
    EXPECT_EQ(landmarking.pairs().size(), 7U);
}

TEST_F(LandmarkingTest, ADragIsOneStep) {
    for (std::size_t i = 0; i < 7; ++i)
        setPair(i);
    ESM_EVENTUALLY(landmarking.fit() && !landmarking.isElsewhere());
    const Projector before = placed();
    const int steps = document.undoStack()->count();
    for (int i = 1; i <= 5; ++i)
        landmarking.movePixel(2, seen(vertex(2)) + Eigen::Vector2d(0.2 * i, 0));
    landmarking.finishMove();
    ESM_EVENTUALLY(landmarking.fit() && !landmarking.isElsewhere());
    EXPECT_FALSE(placed() == before);
    EXPECT_EQ(document.undoStack()->count(), steps + 1);
    document.undoStack()->undo();
    EXPECT_TRUE(placed() == before);
}

TEST_F(LandmarkingTest, AMoveThatIsDroppedLeavesNothing) {
    for (std::size_t i = 0; i < 6; ++i)
        setPair(i);
    ESM_EVENTUALLY(landmarking.fit() && !landmarking.isElsewhere());
    const Project before = document.project();
    const int steps = document.undoStack()->count();
    landmarking.movePixel(2, seen(vertex(2)) + Eigen::Vector2d(40, 10));
    ESM_EVENTUALLY(!(placed() == before.layers[0].projector)); // the photo goes along
    landmarking.movePixel(2, seen(vertex(2)) + Eigen::Vector2d(60, 20));
    landmarking.dropMove();
    EXPECT_EQ(document.project(), before);
    EXPECT_EQ(document.undoStack()->count(), steps);
    landmarking.dropMove();
    EXPECT_EQ(document.undoStack()->count(), steps) << "there is no move any more";
    landmarking.movePoint(1, vertex(9));
    landmarking.finishMove();
    landmarking.dropMove();
    EXPECT_EQ(document.undoStack()->count(), steps + 1) << "what was finished stays";
}

TEST_F(LandmarkingTest, MarksWhatDoesNotFit) {
    for (std::size_t i = 0; i < 9; ++i)
        setPair(i);
    landmarking.movePixel(4, seen(vertex(4)) + Eigen::Vector2d(60, 40));
    ESM_EVENTUALLY(landmarking.fit() && landmarking.fit()->outliers[4]);
    EXPECT_GT(landmarking.fit()->errors[4], 50);
    EXPECT_LT(poseError(), 1e-4) << "and does not let it count";
    landmarking.remove(4);
    EXPECT_EQ(landmarking.pairs().size(), 8U);
}

TEST_F(LandmarkingTest, BadPairsLeaveThePhotoWhereItIs) {
    std::vector<LandmarkPair> line, mirrored;
    for (std::size_t i = 0; i < 8; ++i) {
        line.push_back({{10.0 + 20 * double(i), 30}, vertex(i)});
        mirrored.push_back({{size().width - seen(vertex(i)).x(), seen(vertex(i)).y()}, vertex(i)});
    }
    const Projector before = placed();
    for (const auto& [pairs, word] : {std::pair(line, "on a line"), std::pair(mirrored, "mirrored")}) {
        landmarking.replace(pairs);
        const QString named = word;
        ESM_EVENTUALLY(landmarking.failure().contains(named));
        EXPECT_TRUE(placed() == before) << word;
        EXPECT_EQ(landmarking.pairs(), pairs);
    }
}

TEST_F(LandmarkingTest, AMeasuredCameraStaysAsItIs) {
    document.edit("camera", [&](Project& project) {
        project.layers[0].projector.kind = ProjectorKind::Perspective;
        project.layers[0].projector.intrinsics = intrinsicsOf(truth, size());
    });
    for (std::size_t i = 0; i < 4; ++i)
        setPair(i);
    ESM_EVENTUALLY(landmarking.fit() && poseError() < 1e-4);
    EXPECT_EQ(landmarking.fit()->focalLength, PartSource::Given);
    EXPECT_EQ(placed().intrinsics, intrinsicsOf(truth, size()));
}

class LandmarksInTheWindow : public EditorTest {};

TEST_F(LandmarksInTheWindow, AreSetInThePhotoAndOnTheOrgan) {
    Project before = makeSample("liver");
    before.layers.resize(1);
    before.layers[0].photo = makeSamplePhoto("serosa");
    open(before);
    window->windowActions().texture->trigger();
    auto* photo = child<PhotoView>("photoView");
    ASSERT_FALSE(photo->isVisible());
    press(Qt::Key_M);
    ASSERT_EQ(toolInHand(), "landmarks");
    ESM_EVENTUALLY(photo->isVisible() && window->view().width() > 200);
    settledHeight(&window->view());
    window->view().frameOrgan();
    QTest::mouseClick(photo, Qt::LeftButton, Qt::NoModifier, photo->placeOf({30, 40}).toPoint());
    EXPECT_TRUE(photo->hint().contains("organ"));
    EXPECT_TRUE(project().layers[0].landmarks.empty());
    QTest::mouseClick(&window->view(), Qt::LeftButton, Qt::NoModifier, window->view().rect().center());
    ASSERT_EQ(project().layers[0].landmarks.size(), 1U);
    const LandmarkPair pair = project().layers[0].landmarks[0];
    EXPECT_LT((pair.photo - Eigen::Vector2d(30, 40)).norm(), 2);
    EXPECT_TRUE(boundingBox(project().mesh->vertices).contains(pair.organ));
    auto* list = child<QListWidget>("landmarkList");
    ASSERT_EQ(list->count(), 1);
    list->setCurrentRow(0);
    QTest::keyClick(list, Qt::Key_Delete);
    EXPECT_TRUE(project().layers[0].landmarks.empty());
    window->windowActions().undo->trigger();
    EXPECT_EQ(project().layers[0].landmarks, std::vector<LandmarkPair>{pair});
    window->windowActions().tool("look")->trigger();
    EXPECT_FALSE(photo->isVisible());
}

TEST_F(LandmarksInTheWindow, LieBesideEachOtherWhereThereIsRoom) {
    Project before = makeSample("liver");
    before.layers.resize(1);
    before.layers[0].photo = makeSamplePhoto("serosa");
    open(before);
    window->windowActions().texture->trigger();
    QAction& left = *window->windowActions().showLeft;
    ASSERT_TRUE(left.isChecked());
    press(Qt::Key_M);
    EXPECT_FALSE(left.isChecked()) << "the photo takes its place";
    auto* photo = child<PhotoView>("photoView");
    const auto inWindow = [&](QWidget* widget) {
        return QRect(widget->mapTo(window.get(), {}), widget->size());
    };
    window->resize(1400, 800);
    ESM_EVENTUALLY(window->width() == 1400);
    settledHeight(&window->view());
    EXPECT_LT(inWindow(photo).right(), inWindow(&window->view()).left());
    EXPECT_NEAR(photo->width(), window->view().width(), 20);
    window->resize(760, 800);
    ESM_EVENTUALLY(window->width() == 760);
    settledHeight(&window->view());
    EXPECT_LT(inWindow(photo).bottom(), inWindow(&window->view()).top()) << "one above the other";
    EXPECT_NEAR(photo->height(), window->view().height(), 20);
    press(Qt::Key_V);
    EXPECT_TRUE(left.isChecked());
}

/// Points of the organ that both the photo's camera and the view see, and whose places in the photo lie
/// apart.
std::vector<Eigen::Vector3d> landmarksOf(const TriangleMesh& mesh, const Projector& camera, PhotoSize photo,
                                         std::size_t count) {
    const SurfaceQuery query(mesh.vertices, mesh.triangles);
    const std::vector<Eigen::Vector3d> normals = vertexNormals(mesh.vertices, mesh.triangles);
    std::vector<Eigen::Vector3d> found;
    for (std::size_t i = 0; i < mesh.vertices.size() && found.size() < count; i += 37) {
        const Eigen::Vector3d& point = mesh.vertices[i];
        const auto seen = esm::project(camera, photo, point);
        const Eigen::Vector3d eye = camera.pose.translation();
        const bool isInside = seen && seen->x() > 60 && seen->y() > 60 && seen->x() < photo.width - 60 &&
                              seen->y() < photo.height - 60;
        // At the outline half a pixel of the view lies beside the organ.
        const bool isFacing = (eye - point).normalized().dot(normals[i]) > 0.4;
        if (!isInside || !isFacing || query.isBlocked(point, eye, 1e-3)) continue;
        const bool isApart = std::all_of(found.begin(), found.end(), [&](const Eigen::Vector3d& other) {
            return (esm::project(camera, photo, other)->head<2>() - seen->head<2>()).norm() > 150;
        });
        if (isApart) found.push_back(point);
    }
    return found;
}

TEST_F(LandmarksInTheWindow, GiveAKnownCameraBackFromEightClicks) {
    ESM_SKIP_WITHOUT(knownCameraFolder());
    PolygonSoup soup = readMeshFile(sharedData("meshes/sks-liver-H07.ply"));
    convertToMetres(soup, LengthUnit::Millimetre, UpAxis::Y);
    Project before = makeProject("H07", repair(soup));
    before.layers.resize(1);
    before.layers[0].photo = loadPhoto(knownCameraFolder() / "synthetic-left.png");
    const Image& image = before.layers[0].photo->image;
    const PhotoSize size{image.width, image.height};
    const Projector truth = knownCamera();
    open(before);
    Preview& preview = window->preview();
    preview.setPlaying(false); // clicks on what moves would lie beside
    preview.reset();
    ESM_EVENTUALLY(preview.frame().positions == before.network->restPositions && !preview.status().playing);
    window->windowActions().texture->trigger();
    window->windowActions().tool("landmarks")->trigger();
    auto* photo = child<PhotoView>("photoView");
    OrganView& organ = window->view();
    ESM_EVENTUALLY(photo->isVisible() && organ.height() > 200);
    settledHeight(&organ);
    organ.setCamera(cameraOf(truth, size));
    const auto landmarks = landmarksOf(*before.mesh, truth, size, 8);
    ASSERT_EQ(landmarks.size(), 8U);
    for (const Eigen::Vector3d& landmark : landmarks) {
        const Eigen::Vector2d pixel = esm::project(truth, size, landmark)->head<2>();
        QTest::mouseClick(photo, Qt::LeftButton, Qt::NoModifier, photo->placeOf(pixel).toPoint());
        const auto seen =
            picturePoint(organ.camera(), landmark, double(organ.width()) / std::max(1, organ.height()));
        ASSERT_TRUE(seen);
        QTest::mouseClick(&organ, Qt::LeftButton, Qt::NoModifier,
                          QPoint(qRound(seen->x() * organ.width()), qRound(seen->y() * organ.height())));
        QTest::qWait(0);
    }
    ASSERT_EQ(project().layers[0].landmarks.size(), 8U);
    ESM_EVENTUALLY(project().layers[0].projector.kind == ProjectorKind::Perspective);
    ESM_EVENTUALLY(!window->findChild<Landmarking*>()->isSeeking());
    const Projector& found = project().layers[0].projector;
    const double extent = boundingBox(before.mesh->vertices).diagonal().norm();
    double worst = 0;
    for (const Eigen::Vector3d& landmark : landmarks)
        worst = std::max(worst, (esm::project(found, size, landmark)->head<2>() -
                                 esm::project(truth, size, landmark)->head<2>())
                                    .norm());
    EXPECT_LT(worst, 12) << "photo pixels; one pixel of the view is two or three of the photo";
    EXPECT_LT((found.pose.translation() - truth.pose.translation()).norm(), 0.1 * extent);
    std::cout << "worst " << worst << " px, eye off "
              << 1000 * (found.pose.translation() - truth.pose.translation()).norm() << " mm\n";
}

TEST_F(LandmarksInTheWindow, AreLoadedAndSaved) {
    const TemporaryFolder folder;
    const std::vector<LandmarkPair> pairs{{{1, 2}, {0.1, 0.2, 1.0 / 3}}, {{3, 4}, {0, 0, 0}}};
    writePairsFile(pairs, folder / "in.csv");
    Project before = makeSample("liver");
    before.layers.resize(1);
    before.layers[0].photo = makeSamplePhoto("serosa");
    open(before);
    window->windowActions().texture->trigger();
    DialogScript script;
    script.expectFile(folder / "in.csv");
    child<QPushButton>("loadLandmarks")->click();
    ASSERT_EQ(project().layers[0].landmarks, pairs);
    script.expectFile(folder / "out.csv");
    child<QPushButton>("saveLandmarks")->click();
    EXPECT_EQ(readPairsFile(folder / "out.csv"), pairs);
    EXPECT_TRUE(script.isDone());
}

} // namespace

TEST_F(LandmarkingTest, RefinesAPlacementByAnotherPhotoAsOneStep) {
    EXPECT_FALSE(landmarking.mayRefine()) << "there is no other";
    document.edit(QStringLiteral("Add"), [&](Project& project) {
        project.layers[0].photo = makeSamplePhoto("vessels");
        project.layers[0].projector = truth;
        TextureLayer other = project.layers[0];
        other.id = {};
        project.layers.push_back(other);
        project.layers[0].projector.pose.translation() += Eigen::Vector3d(0.002, -0.0015, 0);
    });
    selection.setPhoto(document.project().layers[0].id);
    const Projector moved = placed();
    const int steps = document.undoStack()->count();
    landmarking.refine();
    EXPECT_TRUE(landmarking.isRefining());
    ESM_EVENTUALLY(!landmarking.isRefining());
    ASSERT_TRUE(landmarking.refinement());
    EXPECT_LT(landmarking.refinement()->errorAfter, landmarking.refinement()->errorBefore / 2);
    EXPECT_LT(poseError(), 0.0025 / 2) << "far away a turn looks much like a shift";
    EXPECT_EQ(document.undoStack()->count(), steps + 1);
    document.undoStack()->undo();
    EXPECT_TRUE(placed() == moved);
    EXPECT_FALSE(landmarking.refinement()) << "the photo stands elsewhere";
}

TEST_F(LandmarkingTest, SaysThatNothingLiesBeneathToRefineBy) {
    document.edit(QStringLiteral("Add"), [&](Project& project) {
        TextureLayer other = project.layers[0];
        other.id = {};
        other.projector.pose.translation().x() += 10;
        project.layers.push_back(other);
    });
    selection.setPhoto(document.project().layers[0].id);
    const Projector before = placed();
    landmarking.refine();
    ESM_EVENTUALLY(!landmarking.isRefining());
    EXPECT_TRUE(landmarking.wasRefinedInVain());
    EXPECT_TRUE(placed() == before);
}
