#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/exchange/project/project_file.h"
#include "core/exchange/project/projector_file.h"
#include "core/exchange/project/scene_file.h"
#include "core/project/detail_change.h"
#include "core/solid/filled_body.h"
#include "core/support/file_io.h"
#include "tests/core/exchange/export_package.h"
#include "tests/core/exchange/own_springs.h"
#include "tests/support/exchange_projects.h"

#include <cstdio>
#include <exception>
#include <map>

/// Made the files in `tests/data`, see the README there. `make_samples FOLDER` writes them as they are today.
namespace {

using namespace esm;

/// Photos projected as a camera sees them, by field of view and by intrinsics, and with falloff.
Project perspectiveProject() {
    Project project = richProject();
    for (TextureLayer& layer : project.layers)
        layer.projector = {};
    project.layers[0].projector.kind = ProjectorKind::Perspective;
    project.layers[0].projector.fieldOfView = 100.0 / 3;
    project.layers[1].projector.kind = ProjectorKind::Perspective;
    project.layers[1].projector.intrinsics = Intrinsics{1e4 / 3, 900, -3, 0.1};
    project.layers[2].projector.falloff = true;
    return project;
}

Project foundCameraProject() {
    Project project = perspectiveProject();
    project.layers[0].projector = {};
    project.layers[0].projector.height = 0.1 / 3;
    project.layers[1].projector.areIntrinsicsFound = true;
    project.texture.occlusionReach = 0.05 / 3;
    return project;
}

PhotoPreparation versionSevenPreparation() {
    PhotoPreparation preparation;
    preparation.field = PhotoField::circle({20.25, 1.0 / 3}, 11, 2.5);
    preparation.highlightThreshold = 200;
    preparation.evenLight = 0.7;
    preparation.whiteBalance = ColourGains{0.9, 1, 1.0 / 0.9};
    preparation.lens = Lens{LensKind::Pinhole, {30, 31, 20, 19}, {-0.1, 0.01, 0.001, 1.0 / 3000, 0.002}};
    preparation.crop = PhotoCrop{1, 2, 12, 11};
    return preparation;
}

/// Photos with every preparation that version 7 knows, on an atlas of matched rows.
Project preparedProject() {
    Project project = richProject();
    prepare(project.layers[0], versionSevenPreparation());
    PhotoPreparation fisheye;
    fisheye.lens = Lens{LensKind::Fisheye, {9, 9, 8, 8}, {-0.1, 0.01, 0.001, 1.0 / 3000, 0}};
    prepare(project.layers[1], fisheye);
    return project;
}

/// Brush strokes on the organ and on a photo, matched colours and landmarks, on an atlas of unfolded groups
/// that was asked for by its density.
Project newestProject() {
    Project project = paintedProject();
    PhotoPreparation masked = versionSevenPreparation();
    masked.strokes = {{{{1, 1.0 / 3}, {5, 6}}, 4.5, 0.25, false}, {{{2, 2}}, 1, 0, true}};
    masked.match = ColourMatch{{1.0 / 0.9, 1, 0.7}, {-1.0 / 3, 5, 6}};
    prepare(project.layers[0], masked);
    project.layers[1].landmarks = {{{1.0 / 3, 20}, {0.1, -1.0 / 7, 1e-9}}, {{-3, 4.5}, {0, 2, 3}}};
    project.texture.atlas = {64, 4, 1, AtlasLayout::UnfoldedGroups, 1000.0 / 3};
    project.atlas = std::make_shared<Atlas>(packAtlas(*project.mesh, project.texture.atlas));
    return project;
}

/// Fields of both shapes that version 10 brought, outlines in a mask, and highlights by their surroundings.
Project shapedProject() {
    Project project = richProject();
    PhotoPreparation ellipse, polygon;
    ellipse.field = PhotoField{FieldShape::Ellipse, {8.25, 7.0 / 3}, {9, 5}, -100.0 / 3, {}, 2.5};
    ellipse.highlightSensitivity = 2.0 / 3;
    polygon.field =
        PhotoField{FieldShape::Polygon, {0, 0}, {0, 0}, 0, {{0, 1.0 / 3}, {9, 0}, {8, 8}, {1, 9}}, 0};
    polygon.strokes = {{{{1, 1.0 / 3}, {5, 6}, {2, 4}}, 0.5, 0, false, true}, {{{2, 2}}, 1, 0, true}};
    prepare(project.layers[0], ellipse);
    prepare(project.layers[1], polygon);
    return project;
}

/// Colours adjusted as version 11 brought it.
Project adjustedProject() {
    Project project = richProject();
    PhotoPreparation all, hue;
    all.adjustment = {10.0 / 3, 250.5, 1.0 / 3, 1.25, 0.5, -100.0 / 3};
    hue.adjustment.hue = 20;
    prepare(project.layers[0], all);
    prepare(project.layers[1], hue);
    return project;
}

/// Every blending that version 11 brought.
Project blendedProject() {
    Project project = richProject();
    project.layers[0].blending = Blending::Screen;
    project.layers[1].blending = Blending::Overlay;
    project.layers[2].blending = Blending::Colour;
    return project;
}

/// Strokes of a pen beside those of a mouse.
Project pressedProject() {
    Project project = paintedProject();
    for (TextureLayer& layer : project.layers)
        for (std::size_t i = 0; i < layer.strokes.size(); i += 2) {
            BrushStroke pressed = *layer.strokes[i];
            for (std::size_t point = 0; point < pressed.path.size(); ++point)
                pressed.shares.push_back({1.0 / static_cast<double>(point + 1), 2.0 / 3});
            layer.strokes[i] = std::make_shared<const BrushStroke>(std::move(pressed));
        }
    return project;
}

/// What was cloned is healed.
Project healedProject() {
    Project project = paintedProject();
    for (TextureLayer& layer : project.layers)
        for (auto& stroke : layer.strokes)
            if (stroke->kind == BrushKind::Clone) {
                BrushStroke healing = *stroke;
                healing.kind = BrushKind::Heal;
                stroke = std::make_shared<const BrushStroke>(std::move(healing));
            }
    return project;
}

/// As the first packed textures were laid out.
Project projectInRows() {
    Project project = richProject();
    project.texture.atlas.layout = AtlasLayout::Rows;
    project.atlas = std::make_shared<Atlas>(packAtlas(*project.mesh, project.texture.atlas));
    return project;
}

/// Neither photos nor an atlas, so that a package shows the plain surface in its base colour.
Project untextured(Project project) {
    project.layers.clear();
    project.atlas = nullptr;
    return project;
}

Project withInstruments(Project project) {
    const Eigen::Quaterniond half(0, 1, 0, 0), slanted(1 / 3.0, 2 / 3.0, 0, 2 / 3.0);
    project.scene.instruments = {
        {Capsule{0.0025, 0.2}, {{0, {0, 0, 0.1}}, {1.0 / 3, {0, -0.0, 0.05}}}, {half, slanted}, "Schere ü"},
        {Capsule{0.01, 0}, {{-1, {0, 0, 0}}}, {}, {}},
        {Sphere{1.0 / 3}, {{0, {0, 0, 0.1}}}, {}, {}}};
    return project;
}

Project withSplits(Project project) {
    project.scene.splits = {{1.0 / 3, {{0, 1}, {1, 2}}}, {0, {{5, 4}}}};
    return project;
}

Project withFluids(Project project) {
    project.scene.fillings = {{0, 1e5 / 3}};
    project.scene.pressures = {{0, {{0, -0.0}, {1.0 / 3, 2000}, {0.7, -1.0 / 7}}}};
    return project;
}

/// An even sheet that was imported, with a fluid and a pressure in it.
Project withOrigin() {
    Project project = withFluids(sheetProject());
    project.source = MeshSource{"Tube \"1\" ü.stl", std::string(60, 'f') + "0123"};
    return project;
}

/// Small, as a lattice takes much room in a file.
Project filledWith(LatticeKind kind) {
    const Project project = untextured(richProject(3));
    const LatticeFilling filling = kind == LatticeKind::Prisms ? LatticeFilling{kind, 0, 0.01 / 3, 2}
                                                               : fillingOf(*project.mesh, kind, 30);
    return withDetail(project, {Detail::Kind::Filled, 0, filling});
}

Project bendingProject() {
    Project project = untextured(softProject());
    project.base.resistsBending = true;
    project.base.wallThickness = 0.01 / 3;
    return project;
}

std::map<std::string, Project> sampleProjects() {
    return {{"version-1", projectInRows()},
            {"version-1-bare", bareProject()},
            {"version-2", boundProject({Detail::Kind::Nodes, 20})},
            {"version-2-rigid", boundProject({Detail::Kind::Rigid, 0})},
            {"version-3", biphasicProject()},
            {"version-4", extendedInferenceProject()},
            {"version-5", untextured(softProject())},
            {"version-6", perspectiveProject()},
            {"version-7", preparedProject()},
            {"version-8", newestProject()},
            {"version-10", shapedProject()},
            {"version-11-finish", shiningProject()},
            {"version-11-adjusted", adjustedProject()},
            {"version-11-blended", blendedProject()},
            {"version-11-healed", healedProject()},
            {"version-11-pressure", pressedProject()},
            {"version-11-own-layout", ownLayoutProject()},
            {"version-12-filled", filledProject()},
            {"version-12-cubic", filledWith(LatticeKind::Cubic)},
            {"version-12-diamond", filledWith(LatticeKind::Diamond)},
            {"version-12-bare-diamond", filledWith(LatticeKind::BareDiamond)},
            {"version-13-bending", bendingProject()},
            {"version-13-graded", filledWith(LatticeKind::Graded)},
            {"version-13-prisms", filledWith(LatticeKind::Prisms)},
            {"version-13-even-sheet", sheetProject()},
            {"version-13-clinical-units", clinicalProject()},
            {"version-13-found-camera", foundCameraProject()},
            {"version-13-origin", withOrigin()},
            {"version-13-fluids", withFluids(untextured(softProject()))},
            {"version-9-instruments", withInstruments(untextured(softProject()))},
            {"version-9-split", withSplits(untextured(softProject()))},
            {"version-9-wide-binding", untextured(latticeProject())}};
}

/// Packages that projects of the same version are exported as are of this version at most.
constexpr int newestOfProjects = 5;

void writeSamples(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / "projects");
    std::filesystem::create_directories(folder / "packages");
    for (const auto& [name, project] : sampleProjects()) {
        saveProject(project, folder / "projects" / (name + ".esm"));
        if (std::stoi(name.substr(8)) > newestOfProjects) continue; // behind "version-"
        exportPackage(project, folder / "packages" / (name + ".glb"),
                      {{}, [](const Project&, const auto&) { return gradientPhoto("preview", 8)->image; }});
    }
    exportPackage(withFluids(untextured(softProject())), folder / "packages" / "version-9-fluids.glb");
    exportPackage(withOrigin(), folder / "packages" / "version-9-origin.glb",
                  saidBy({"Tube ü", "A. N. Other", "2026-05", "CC0 1.0"}));
    exportPackage(filledProject(), folder / "packages" / "version-8-filled.glb");
    exportPackage(sheetProject(), folder / "packages" / "version-6-even-sheet.glb");
    exportPackage(clinicalProject(), folder / "packages" / "version-9-clinical-units.glb");
    exportPackage(ownLayoutProject(), folder / "packages" / "version-7-own-layout.glb");
    exportPackage(untextured(latticeProject()), folder / "packages" / "version-6-wide-binding.glb");
    exportPackage(shiningProject(), folder / "packages" / "version-1-finish.glb");
    exportPackage(filledWith(LatticeKind::Graded), folder / "packages" / "version-9-graded.glb");
    exportPackage(filledWith(LatticeKind::Prisms), folder / "packages" / "version-9-prisms.glb");
    exportPackage(bendingProject(), folder / "packages" / "version-9-bending.glb");
    const Project soft = untextured(softProject());
    writePackage(withOwnSprings(soft), folder / "packages" / "version-6-own-springs.glb", {});
}

void writeText(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    writeFileAtomically(file, text);
}

/// What people keep in files of their own, as the projects of the same names have it.
void writePartsOf(const std::filesystem::path& folder) {
    const std::map<std::string, Project> projects = sampleProjects();
    for (const char* name : {"version-1", "version-9-instruments", "version-9-split", "version-13-fluids"})
        writeText(folder / "scenes" / (name + std::string(".json")),
                  toJson(projects.at(name).scene).dump(2) + '\n');
    for (std::size_t layer = 0; layer < 3; ++layer)
        for (const char* name : {"version-1", "version-6", "version-13-found-camera"})
            writeText(folder / "projectors" / (name + ("-" + std::to_string(layer)) + ".json"),
                      toJson(projects.at(name).layers[layer].projector).dump(2) + '\n');
    for (const char* name : {"version-1", "version-4", "version-13-clinical-units"})
        for (const Region& region : projects.at(name).regions)
            for (const char* ending : {".json", ".fcl", ".fll"})
                if (region.system) {
                    const std::filesystem::path file = folder / "fuzzy" / (std::string(name) + ending);
                    writeText(file, exportFuzzySystem(*region.system, file).text);
                }
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "make_samples FOLDER\n");
        return 2;
    }
    try {
        writeSamples(arguments[1]);
        writePartsOf(arguments[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_samples: %s\n", error.what());
        return 1;
    }
}
