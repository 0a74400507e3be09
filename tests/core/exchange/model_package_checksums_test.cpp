#include "tests/core/exchange/model_package_fixture.h"

#include "core/exchange/package/package_checksums.h"
#include "tests/core/exchange/rounded_tissue.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/rounds.h"
#include "tests/support/sanitized.h"

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

Project withoutPictures() {
    Project project = richProject();
    project.layers.clear();
    project.atlas = nullptr;
    return project;
}

/// All that is simulated and drawn of a package.
void expectSamePackage(const ModelPackage& package, const ModelPackage& other) {
    expectSameTissue(package.tissue, other.tissue);
    EXPECT_EQ(package.name, other.name);
    EXPECT_EQ(package.mesh.vertices, other.mesh.vertices);
    EXPECT_EQ(package.mesh.triangles, other.mesh.triangles);
    EXPECT_EQ(package.base, other.base);
    EXPECT_EQ(package.regions, other.regions);
    EXPECT_EQ(package.stepping, other.stepping);
    EXPECT_EQ(package.baseColour, other.baseColour);
    ASSERT_EQ(package.textures.size(), other.textures.size());
    for (std::size_t page = 0; page < package.textures.size(); ++page)
        EXPECT_EQ(package.textures[page].pixels, other.textures[page].pixels);
    ASSERT_EQ(package.atlas == nullptr, other.atlas == nullptr);
    if (other.atlas) {
        EXPECT_EQ(package.atlas->corners, other.atlas->corners);
    }
}

class PackageChecksums : public ModelPackageFile {
protected:
    /// Bytes of an array of the extension, from its first on.
    std::size_t placeOf(const Glb& glb, const char* pointer) const {
        const Json& place = glb.json["extensions"]["ESM_spring_mass"].at(Json::json_pointer(pointer));
        const Json& accessor = glb.json["accessors"][place.get<std::size_t>()];
        return glb.json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteOffset"]
            .get<std::size_t>();
    }

    void expectRefusedOrSame(const Project& project, std::size_t step) const {
        exportPackage(project, m_file);
        const Bytes whole = readFile(m_file);
        const ModelPackage sound = loadPackage(m_file);
        std::size_t same = 0;
        for (std::size_t place = seedOf(0) % step; place < whole.size(); place += step) {
            Bytes damaged = whole;
            damaged[place] = static_cast<std::uint8_t>(damaged[place] ^ (1U << (place % 8)));
            overwrite(m_file, damaged);
            try {
                SCOPED_TRACE("byte " + std::to_string(place));
                expectSamePackage(loadPackage(m_file), sound);
                ++same;
            } catch (const FileError&) {
                EXPECT_THROW(loadPackagedTissue(m_file), FileError) << "byte " << place;
            }
        }
        EXPECT_LE(same, 1 + 100 / step) << "sums stand for next to nothing";
    }
};

TEST_F(PackageChecksums, AFlippedBitAnywhereIsRefusedOrChangesNothing) {
    expectRefusedOrSame(withoutPictures(), static_cast<std::size_t>(roundsOf(isSanitized() ? 97 : 7, 1)));
}

TEST_F(PackageChecksums, AFlippedBitOfAPictureIsRefusedToo) {
    expectRefusedOrSame(richProject(), static_cast<std::size_t>(roundsOf(isSanitized() ? 997 : 97, 1)));
}

TEST_F(PackageChecksums, NameTheArrayThatIsDamaged) {
    exportPackage(boundProject({Detail::Kind::Nodes, 20}), m_file);
    const Bytes whole = readFile(m_file);
    const Glb glb = parseGlb(whole);
    const std::size_t binary = whole.size() - glb.binary.size();
    for (const auto& [pointer, name] : std::vector<std::pair<const char*, const char*>>{
             {"/nodes/mass", "nodes.mass is damaged"},
             {"/springs/restLength", "springs.restLength is damaged"},
             {"/tethers/viscosity", "tethers.viscosity is damaged"},
             {"/binding/shares", "binding.shares is damaged"}}) {
        Bytes damaged = whole;
        damaged[binary + placeOf(glb, pointer)] ^= 1;
        overwrite(m_file, damaged);
        EXPECT_THAT(loadingError(), HasSubstr(name));
        EXPECT_THAT(validatePackage(m_file), testing::SizeIs(1)) << name;
    }
}

TEST_F(PackageChecksums, NameWhatIsDrawnAndNobodyReads) {
    exportPackage(withoutPictures(), m_file);
    const Bytes whole = readFile(m_file);
    const Glb glb = parseGlb(whole);
    const Json& normals = glb.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"];
    const Json& view = glb.json["accessors"][normals.get<std::size_t>()]["bufferView"];
    Bytes damaged = whole;
    damaged[whole.size() - glb.binary.size() +
            glb.json["bufferViews"][view.get<std::size_t>()]["byteOffset"].get<std::size_t>()] ^= 1;
    overwrite(m_file, damaged);
    EXPECT_THAT(loadingError(), HasSubstr("NORMAL is damaged"));
}

TEST_F(PackageChecksums, AChangedJsonIsRefusedUntilTheSumsAreLeftOut) {
    exportPackage(withoutPictures(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    glb.json["extensions"]["ESM_spring_mass"]["base"]["viscosity"] = 7.5;
    overwrite(m_file, writeGlb(glb));
    EXPECT_THAT(loadingError(), HasSubstr("the JSON is damaged, or was changed"));
    rewrite(glb);
    EXPECT_EQ(loadPackage(m_file).base.viscosity, 7.5);
}

// Small files could else ask for sums over any number of bytes.
TEST_F(PackageChecksums, OfViewsThatOverlapAreRefused) {
    exportPackage(withoutPictures(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    const Json& normals = glb.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"];
    const Json& view = glb.json["accessors"][normals.get<std::size_t>()]["bufferView"];
    Json& changed = glb.json["bufferViews"][view.get<std::size_t>()];
    changed["byteOffset"] = 0;
    changed["byteLength"] = glb.binary.size();
    fillChecksums(glb);
    overwrite(m_file, writeGlb(glb));
    EXPECT_THAT(loadingError(), HasSubstr("bufferViews overlap"));
    EXPECT_THROW(loadPackagedTissue(m_file), FileError);
}

TEST_F(PackageChecksums, ThatAreNoneAreRefused) {
    exportPackage(withoutPictures(), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    for (const Json& wrong : {Json(0), Json("many"), Json(9999), Json(-1),
                              whole.json["extensions"]["ESM_spring_mass"]["springs"]["nodes"]}) {
        Glb glb = whole;
        glb.json["extensions"]["ESM_spring_mass"]["checksums"] = wrong;
        overwrite(m_file, writeGlb(glb));
        EXPECT_THAT(validatePackage(m_file), testing::Contains(HasSubstr("checksums"))) << wrong;
        EXPECT_THROW(loadPackagedTissue(m_file), FileError) << wrong;
    }
}

} // namespace
} // namespace esm
