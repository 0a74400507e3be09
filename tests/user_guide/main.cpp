// Makes the pictures of docs/user-guide from the running program, on organs and photos that it makes itself.
//   user_guide_pictures FOLDER
// scripts/make-user-guide-pictures.sh builds it and runs it on a display of its own.

#include "app/editor/document/document.h"
#include "app/editor/window/application.h"
#include "app/editor/window/theme.h"
#include "app/editor/workers/preview.h"
#include "core/samples/samples.h"
#include "core/support/file_io.h"
#include "tests/support/scratch_settings.h"
#include "tests/user_guide/guided_window.h"

#include <QAbstractButton>
#include <QLabel>
#include <QPushButton>
#include <QSlider>

#include <algorithm>
#include <cstdio>
#include <sstream>

using namespace guide;

namespace {

/// In the middle of what is seen from the front.
std::uint32_t frontVertex(const esm::TriangleMesh& mesh) {
    const Eigen::Vector3d middle = esm::boundingBox(mesh.vertices).center();
    const auto nearness = [&](const Eigen::Vector3d& vertex) {
        return vertex.z() - 2 * (vertex - middle).head<2>().norm();
    };
    const auto found =
        std::max_element(mesh.vertices.begin(), mesh.vertices.end(),
                         [&](const auto& a, const auto& b) { return nearness(a) < nearness(b); });
    return static_cast<std::uint32_t>(found - mesh.vertices.begin());
}

/// The sample of a liver as a file of others has it: in millimetres, with a hole.
void writeOpenLiver(const std::filesystem::path& file) {
    const esm::Project liver = esm::makeSample("liver");
    std::ostringstream text;
    for (const Eigen::Vector3d& vertex : liver.mesh->vertices)
        text << "v " << 1000 * vertex.x() << ' ' << 1000 * vertex.y() << ' ' << 1000 * vertex.z() << '\n';
    const std::uint32_t missing = frontVertex(*liver.mesh);
    for (const esm::Triangle& triangle : liver.mesh->triangles)
        if (std::find(triangle.begin(), triangle.end(), missing) == triangle.end())
            text << "f " << triangle[0] + 1 << ' ' << triangle[1] + 1 << ' ' << triangle[2] + 1 << '\n';
    esm::writeFileAtomically(file, text.str());
}

void showBeginning(const std::filesystem::path& folder, const std::filesystem::path& scratch) {
    GuidedWindow guided(esm::makeSample("liver"), folder);
    guided.window().start({});
    guided.take("start");
    writeOpenLiver(scratch / "liver.obj");
    guided.takeDialog("import", [&] { guided.window().openFiles({scratch / "liver.obj"}); });
}

void showInside(const std::filesystem::path& folder) {
    GuidedWindow guided(esm::makeSample("liver"), folder);
    guided.window().preview().setPlaying(false);
    guided.takeDialog(
        "inside", [&] { guided.window().windowActions().chooseInside->trigger(); },
        [](QDialog& dialog) {
            auto* fill = dialog.findChild<QPushButton*>(QStringLiteral("insideAccept"));
            waitFor("the lattice", [&] { return fill->isEnabled(); });
        });
}

void showTissue(const std::filesystem::path& folder) {
    GuidedWindow guided(esm::makeSample("liver"), folder);
    guided.window().preview().setPlaying(false);
    guided.tool("region")->trigger();
    guided.take("tissue");
    guided.raise(QStringLiteral("Fuzzy system"));
    guided.raise(QStringLiteral("Domains"));
    guided.take("fuzzy-system");
    guided.raise(QStringLiteral("Tissue"));
    guided.window().preview().setPlaying(true);
    guided.tool("pull")->trigger();
    guided.press(0.35, 0.5);
    guided.drag(0.25, 0.35);
    guided.take("pull");
    guided.release(0.25, 0.35);
}

void showColours(const std::filesystem::path& folder) {
    GuidedWindow guided(esm::makeSample("liver"), folder);
    guided.window().preview().setPlaying(false);
    const esm::Actions& actions = guided.window().windowActions();
    actions.colourings->actions().at(1)->trigger();
    actions.showWireframe->trigger();
    actions.cut->trigger();
    guided.take("cut-open");
}

void showMeasuring(const std::filesystem::path& folder) {
    GuidedWindow guided(esm::makeSample("tube"), folder);
    guided.window().windowActions().measure->trigger();
    guided.part<QPushButton>("measureButton").click();
    waitFor("speed and accuracy", [&] { return guided.window().document().project().accuracy != nullptr; });
    guided.part<QPushButton>("toError").click();
    guided.window().preview().setPlaying(false);
    guided.take("measure");
}

/// A lobe is pulled, and pulled again when it is firmer.
void showPoke(const std::filesystem::path& folder) {
    GuidedWindow guided(esm::makeSample("liver"), folder);
    guided.window().windowActions().measure->trigger();
    guided.part<QTabBar>("measurePages").setCurrentIndex(2);
    auto& record = guided.part<QPushButton>("recordPoke");
    const auto& length = guided.part<QLabel>("pokeLength");
    const auto& cancel = guided.part<QPushButton>("cancelPoke");
    record.click();
    const auto lasts = [&](double seconds) {
        return [&length, seconds] {
            return length.text().section(QLatin1Char(' '), 0, 0).toDouble() >= seconds;
        };
    };
    waitFor("the recording", lasts(0.3));
    guided.press(0.4, 0.5);
    guided.drag(0.33, 0.4);
    waitFor("the pull", lasts(0.9));
    guided.release(0.33, 0.4);
    waitFor("rest", lasts(2.6));
    record.click();
    waitFor("the motion", [&] { return !cancel.isEnabled(); });
    guided.window().document().edit(
        "firmer", [](esm::Project& project) { project.regions.front().inputs.begin()->second = 9; });
    guided.part<QPushButton>("repeatPoke").click();
    waitFor("the motion of firmer tissue", [&] { return !cancel.isEnabled(); });
    guided.part<QSlider>("pokeMoment").setValue(22);
    guided.take("poke");
}

void showPhotos(const std::filesystem::path& folder, const std::filesystem::path& scratch) {
    GuidedWindow guided(esm::makeSample("liver"), folder);
    guided.window().preview().setPlaying(false);
    const auto photo = esm::makeSamplePhoto("vessels");
    esm::writeFileAtomically(scratch / "vessels.png", photo->encoded);
    guided.window().openFiles({scratch / "vessels.png"});
    waitFor("the photo", [&] { return !guided.window().document().project().layers.empty(); });
    guided.tool("projector")->trigger();
    guided.take("texture");
    guided.tool("landmarks")->trigger();
    guided.take("landmarks");
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: user_guide_pictures FOLDER\n");
        return 2;
    }
    const ScratchSettings scratch;
    esm::Application application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("esm"));
    QCoreApplication::setApplicationName(QStringLiteral("esm-user-guide"));
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    esm::applyTheme(application, esm::Theme::Dark);
    const std::filesystem::path folder = argv[1];
    showBeginning(folder, scratch.folder());
    showInside(folder);
    showTissue(folder);
    showColours(folder);
    showMeasuring(folder);
    showPoke(folder);
    showPhotos(folder, scratch.folder());
}
