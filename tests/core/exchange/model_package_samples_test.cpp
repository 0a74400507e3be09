#include "core/exchange/package/glb.h"
#include "core/exchange/package/package_layout.h"
#include "core/exchange/package/xmp_packet.h"
#include "core/exchange/project/project_file.h"
#include "tests/core/exchange/export_package.h"
#include "tests/core/exchange/own_springs.h"
#include "tests/core/exchange/rounded_tissue.h"
#include "tests/support/samples.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

namespace esm {
namespace {

using PackageJson = nlohmann::ordered_json;

/// The project that a sample was exported from: of its name, or of what a newer version of projects brought.
std::filesystem::path projectOf(const std::filesystem::path& package) {
    static const std::map<std::string, std::string> ofNewer{
        {"version-1-finish", "version-11-finish"},
        {"version-6-wide-binding", "version-9-wide-binding"},
        {"version-6-even-sheet", "version-13-even-sheet"},
        {"version-9-clinical-units", "version-13-clinical-units"},
        {"version-8-filled", "version-12-filled"},
        {"version-9-bending", "version-13-bending"},
        {"version-9-graded", "version-13-graded"},
        {"version-9-prisms", "version-13-prisms"},
        {"version-9-fluids", "version-13-fluids"},
        {"version-9-origin", "version-13-origin"}};
    const auto newer = ofNewer.find(package.stem());
    const std::string name = newer == ofNewer.end() ? package.stem().string() : newer->second;
    return package.parent_path() / ".." / "projects" / (name + ".esm");
}

/// Those that were exported from a project.
std::vector<std::filesystem::path> exportedPackages() {
    std::vector<std::filesystem::path> packages;
    for (const std::filesystem::path& file : samples("packages"))
        if (exists(projectOf(file))) packages.push_back(file);
    return packages;
}

/// Without the version of the program, and without the places of arrays and pictures in the binary part,
/// which are compared by what lies there.
PackageJson comparable(PackageJson json) {
    EXPECT_EQ(json["asset"].erase("generator"), 1U);
    json.erase("buffers");
    PackageJson& extension = json["extensions"][package_layout::extension];
    if (extension.contains("provenance")) extension["provenance"].erase("program");
    if (json["extensions"].contains(xmpExtension))
        json["extensions"][xmpExtension]["packets"][0].erase("xmp:CreatorTool");
    for (PackageJson& image : json["images"])
        if (image.value("name", "") != "preview") image.erase("name"); // which programs before did not write
    for (PackageJson& view : json["bufferViews"]) {
        view.erase("byteOffset");
        view.erase("byteLength");
    }
    return json;
}

Bytes bytesOfView(const Glb& glb, const PackageJson& place) {
    std::vector<std::string> problems;
    const Bytes bytes = GltfArrayReader(glb, problems).file(JsonReader(place, "bufferView", problems));
    EXPECT_THAT(problems, testing::IsEmpty());
    return bytes;
}

/// Without the keys that programs did not write when a sample was made, whose arrays follow those they wrote.
PackageJson withoutNewerKeys(PackageJson json, const PackageJson& before) {
    const auto eraseNewer = [](PackageJson& holder, const PackageJson& old,
                               std::initializer_list<const char*> keys) {
        for (const char* key : keys)
            if (!old.contains(key)) holder.erase(key);
    };
    PackageJson& extension = json["extensions"][package_layout::extension];
    const PackageJson& old = before["extensions"][package_layout::extension];
    eraseNewer(extension, old, {"provenance", "pressures", "material", "checksums"});
    eraseNewer(extension["springs"], old["springs"], {"kind"});
    for (std::size_t i = 0; i < json["meshes"][0]["primitives"].size(); ++i)
        eraseNewer(json["meshes"][0]["primitives"][i]["attributes"],
                   before["meshes"][0]["primitives"][i]["attributes"],
                   {"_ESM_MASS", "_ESM_SPRING_CONSTANT", "_ESM_VISCOSITY", "_ESM_FIXED", "_ESM_VERTEX"});
    for (const char* list : {"accessors", "bufferViews"})
        while (json[list].size() > before[list].size())
            json[list].erase(json[list].size() - 1);
    return json;
}

/// Every JSON value and the bytes of every accessor.
void expectSameGlb(const std::filesystem::path& before, const std::filesystem::path& after) {
    const Glb old = parseGlb(readFile(before)), fresh = parseGlb(readFile(after));
    const PackageJson a = comparable(old.json), b = withoutNewerKeys(comparable(fresh.json), a);
    EXPECT_EQ(PackageJson::diff(a, b), PackageJson::array());
    ASSERT_TRUE(a.dump() == b.dump()) << "the order of keys differs, or the sign of a 0";
    const PackageJson sums = a["extensions"][package_layout::extension].value("checksums", PackageJson());
    for (std::size_t place = 0; place < a["accessors"].size(); ++place) {
        if (sums == place) continue; // one of them is that of the JSON, which names the program
        const PackageJson& view = a["accessors"][place]["bufferView"];
        EXPECT_TRUE(bytesOfView(old, view) == bytesOfView(fresh, view)) << a["accessors"][place];
    }
}

/// The share of texels that have the same colour.
double sameShare(const Image& a, const Image& b) {
    std::size_t same = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 4)
        same += std::equal(&a.pixels[i], &a.pixels[i] + 4, &b.pixels[i]) ? 1 : 0;
    return 4.0 * static_cast<double>(same) / static_cast<double>(a.pixels.size());
}

/// Photos have come to fade out towards the outlines of what their projector sees: there colours may differ,
/// and nowhere else.
void expectSameTextures(const ModelPackage& a, const ModelPackage& b) {
    constexpr double leastSame = 0.87;
    ASSERT_EQ(a.textures.size(), b.textures.size());
    for (std::size_t page = 0; page < a.textures.size(); ++page) {
        ASSERT_EQ(a.textures[page].pixels.size(), b.textures[page].pixels.size());
        EXPECT_GE(sameShare(a.textures[page], b.textures[page]), leastSame) << page;
    }
}

int writtenVersionOf(const PackageJson& gltf) {
    return gltf["extensions"][package_layout::extension]["version"].get<int>();
}

TEST(ModelPackageSamples, AreOfEveryVersion) {
    std::set<int> versions;
    for (const std::filesystem::path& file : samples("packages"))
        versions.insert(writtenVersionOf(parseGlb(readFile(file)).json));
    for (int version = 1; version <= modelPackageVersion; ++version)
        EXPECT_EQ(versions.count(version), 1U) << version;
}

TEST(ModelPackageSamples, HoldWhatTheirProjectsHold) {
    for (const std::filesystem::path& file : exportedPackages()) {
        SCOPED_TRACE(file.filename());
        EXPECT_THAT(validatePackage(file), testing::IsEmpty());
        const ModelPackage package = loadPackage(file);
        const Project project = loadProject(projectOf(file));
        EXPECT_EQ(package.name, project.name);
        EXPECT_EQ(package.mesh.triangles, project.mesh->triangles);
        EXPECT_EQ(package.mesh.vertices, rounded(project.mesh->vertices));
        expectSameTissue(package.tissue, evaluateModel(project));
        expectSameRegions(package.regions, project.regions);
        expectSameStepping(package.stepping, project.stepping);
        EXPECT_EQ(package.baseColour, project.texture.baseColour);
    }
}

TEST(ModelPackageSamples, AreExportedAsTheyWere) {
    const TemporaryFolder folder;
    for (const std::filesystem::path& file : exportedPackages()) {
        SCOPED_TRACE(file.filename());
        const ModelPackage package = loadPackage(file);
        const std::filesystem::path again = folder / "again.glb";
        HandoverMeans means;
        means.drawPreview = [&](const Project&, const auto&) { return package.preview; };
        if (package.provenance) means.authorship = package.provenance->authorship;
        exportPackage(loadProject(projectOf(file)), again, means);
        expectSameGlb(file, again);
        expectSameTextures(package, loadPackage(again));
    }
}

TEST(ModelPackageSamples, HoldSpringsOfTheirOwn) {
    const TemporaryFolder folder;
    const std::filesystem::path again = folder / "again.glb";
    for (const std::filesystem::path& file : samples("packages")) {
        if (file.stem() != "version-6-own-springs") continue;
        const Handover handover =
            withOwnSprings(loadProject(projectOf(file.parent_path() / "version-5.glb")));
        expectSameTissue(loadPackage(file).tissue, handover.tissue);
        writePackage(handover, again, {});
        expectSameGlb(file, again);
    }
    EXPECT_TRUE(exists(again));
}

} // namespace
} // namespace esm
