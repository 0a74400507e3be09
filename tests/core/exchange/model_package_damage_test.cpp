#include "tests/core/exchange/model_package_fixture.h"

#include "core/exchange/package/glb.h"
#include "core/support/byte_order.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/support/exchange_projects.h"

#include <algorithm>
#include <functional>
#include <set>

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST_F(ModelPackageFile, ABindingThatCannotCarryTheSurfaceIsRefused) {
    const auto refusal = [&](const char* key, const Json& value) {
        exportPackage(boundProject({Detail::Kind::Nodes, 20}), m_file);
        Glb glb = parseGlb(readFile(m_file));
        glb.json["extensions"]["ESM_spring_mass"]["binding"][key] = value;
        rewrite(glb);
        return loadingError();
    };
    const Json extension = [&] {
        exportPackage(boundProject({Detail::Kind::Nodes, 20}), m_file);
        return parseGlb(readFile(m_file)).json["extensions"]["ESM_spring_mass"];
    }();
    EXPECT_THAT(refusal("nodes", extension["surface"]["triangles"]), HasSubstr("binding.nodes"));
    EXPECT_THAT(refusal("shares", extension["surface"]["restPosition"]), HasSubstr("shares are not of one"));
    EXPECT_THAT(refusal("triangleCount", 7), HasSubstr("binding.triangles"));
    EXPECT_THAT(refusal("lineCount", 1), HasSubstr("binding.lines is missing"));
    EXPECT_THAT(refusal("lineCount", -1), HasSubstr("binding.lineCount"));
}

TEST_F(ModelPackageFile, RowsOfNodesThatCannotCarryTheSurfaceAreRefused) {
    exportPackage(rowsProject(4), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    const auto refusal = [&](const char* key, std::size_t place, std::uint32_t number) {
        Glb glb = whole;
        const Json& accessor =
            glb.json["accessors"]
                    [glb.json["extensions"]["ESM_spring_mass"]["binding"][key].get<std::size_t>()];
        const Json& view = glb.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        Bytes bytes;
        appendLittleEndian(bytes, number);
        std::copy(bytes.begin(), bytes.end(),
                  glb.binary.begin() + view.value("byteOffset", 0) + static_cast<std::ptrdiff_t>(4 * place));
        rewrite(glb);
        EXPECT_THAT(validatePackage(m_file), testing::SizeIs(1)) << key << " " << number;
        EXPECT_THROW(loadPackagedTissue(m_file), FileError);
        return loadingError();
    };
    for (const auto& [place, number] : std::vector<std::pair<std::size_t, std::uint32_t>>{
             {0, 1}, {1, 0}, {1, 8}, {2, 4294967295U}, {48, 0}, {48, 4294967295U}})
        EXPECT_THAT(refusal("starts", place, number), HasSubstr("starts of the rows of nodes")) << number;
    EXPECT_THAT(refusal("nodes", 7, 20), HasSubstr("20 as number 7"));
    EXPECT_THAT(refusal("shares", 3, 0), HasSubstr("drawn point 0"));
    EXPECT_THAT(refusal("shares", 3, 0x7F800000), HasSubstr("not finite"));
}

TEST_F(ModelPackageFile, RowsOfNodesOfOtherLengthsThanTheirArraysAreRefused) {
    exportPackage(rowsProject(4), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    const auto refusal = [&](const std::function<void(Json&)>& change) {
        Glb glb = whole;
        change(glb.json["extensions"]["ESM_spring_mass"]);
        rewrite(glb);
        return loadingError();
    };
    const Json& extension = whole.json["extensions"]["ESM_spring_mass"];
    const auto given = [&](const char* key, const Json& accessor) {
        return refusal([&](Json& changed) { changed["binding"][key] = accessor; });
    };
    EXPECT_THAT(given("starts", extension["binding"]["nodes"]), HasSubstr("binding.starts"));
    EXPECT_THAT(given("nodes", extension["binding"]["starts"]), HasSubstr("binding.shares"));
    EXPECT_THAT(given("nodes", 9999), HasSubstr("binding.nodes"));
    EXPECT_THAT(given("shares", extension["nodes"]["mass"]), HasSubstr("binding.shares"));
    EXPECT_THAT(refusal([](Json& changed) { changed["binding"].erase("starts"); }),
                HasSubstr("binding.nodes"));
    EXPECT_THAT(refusal([](Json& changed) { changed["version"] = 5; }), HasSubstr("version should be 6"));
}

TEST_F(ModelPackageFile, ASpringLawIsRefusedThatAReaderCouldMissOrTakeForAnother) {
    const auto refusal = [&](const auto& change) {
        exportPackage(biphasicProject(), m_file);
        Glb glb = parseGlb(readFile(m_file));
        change(glb.json["extensions"]["ESM_spring_mass"]);
        rewrite(glb);
        return loadingError();
    };
    EXPECT_THAT(refusal([](Json& extension) { extension.erase("stiffening"); }),
                HasSubstr("base should have"));
    EXPECT_THAT(refusal([](Json& extension) { extension["stiffening"]["factor"] = 2; }),
                HasSubstr("base should have"));
    EXPECT_THAT(refusal([](Json& extension) { extension["version"] = 2; }), HasSubstr("version should be 3"));
    const std::pair<Json, const char*> laws[]{
        {{{"strain", 0}, {"factor", 5}}, "the strain"},
        {{{"strain", 0.2}, {"factor", 0}}, "the factor"},
        {{{"strain", 0.2}, {"factor", 1e30}}, "spring constant of stretched springs"}};
    for (const auto& [law, named] : laws)
        EXPECT_THAT(refusal([&law = law](Json& extension) {
                        extension["stiffening"] = extension["base"]["stiffening"] = law;
                    }),
                    HasSubstr(named));
}

TEST_F(ModelPackageFile, AFileCutOffAnywhereIsRefused) {
    exportPackage(richProject(), m_file);
    const Bytes whole = readFile(m_file);
    for (std::size_t size = 0; size < whole.size(); size += size < 64 ? 1 : 101) {
        overwrite(m_file, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
        ASSERT_THAT(loadingError(), HasSubstr("organ.glb: ")) << size;
    }
}

TEST_F(ModelPackageFile, AFuzzySystemIsRefusedThatAReaderWouldInferOtherwise) {
    exportPackage(extendedInferenceProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    glb.json["extensions"]["ESM_spring_mass"]["version"] = 3;
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("version should be 4"));
}

TEST_F(ModelPackageFile, ASoftRimIsRefusedThatAReaderWouldTakeForSharp) {
    exportPackage(softProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    glb.json["extensions"]["ESM_spring_mass"]["version"] = 4;
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("version should be 5"));
}

struct Damage {
    const char* pointer; ///< from the extension, or from the root where it starts with "//"
    Json value;
    const char* named; ///< what the message must name
};

TEST_F(ModelPackageFile, AnyWrongValueIsRefusedByItsName) {
    exportPackage(richProject(), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    const std::vector<Damage> cases{
        {"/version", 10,
         "was made by a newer version (10) of the program; this one reads up to 9; update the program"},
        {"/version", "one", "version"},
        {"/damping", "axial", "damping"},
        {"/stiffening", true, "stiffening"},
        {"/stiffening", {{"strain", 0.2}}, "stiffening.factor"},
        {"/nodes", nullptr, "nodes"},
        {"/nodes/count", 47, "should have 47 elements"},
        {"/nodes/count", 4000000000U, "count"},
        {"/nodes/restPosition", 999, "restPosition"},
        {"/nodes/restPosition", "first", "restPosition"},
        {"/nodes/mass", 0, "accessors"},
        {"/springs/nodes", 1, "accessors"},
        {"/springs/springConstant", 1, "accessors"},
        {"/tethers/count", -1, "count"},
        {"/fixedNodes/nodes", nullptr, "fixedNodes"},
        {"/surface/triangles", nullptr, "triangles"},
        {"/surface/vertexCount", 1, "surface"},
        {"/regions", 5, "regions"},
        {"/regions/0/fuzzySystem", 44, "fuzzySystem"},
        {"/regions/2/held/mass", -1, "region 3"},
        {"/regions/2/rim", "wide", "rim"},
        {"/stepping/integrator", "auto", "stepping: auto"},
        {"/stepping/timeStep", -1, "stepping: the time step"},
        {"/stepping/precision", 2, "stepping.precision"},
        {"/texture/size", 64, "64 by 64"},
        {"/texture/gap", 1e30, "gap"},
        {"/drawn", Json::array(), "drawn"},
        {"/drawn/0/primitive", 3, "primitive"},
        {"/drawn/0/mesh", 3, "mesh"},
        {"/drawn/0/vertexNodes", nullptr, "vertexNodes"},
        {"//asset/version", "1.0", "asset"},
        {"//extensionsUsed", Json::array(), "extensionsUsed"},
        {"/nodes", {1}, "nodes should be an object"},
        {"//extensions", Json::object(), "no model package"},
        {"//accessors", nullptr, "accessors"},
        {"//accessors/0/count", 18446744073709551615U, "accessors"},
        {"//accessors/0/byteOffset", 18446744073709551612U, "byteOffset"},
        {"//accessors/0/byteOffset", 1, "accessors"},
        {"//accessors/0/type", "VEC2", "VEC3"},
        {"//accessors/0/componentType", 5125, "componentType"},
        {"//accessors/0/sparse", Json::object(), "sparse"},
        {"//bufferViews/0/byteLength", 1U << 31, "byteLength"},
        {"//bufferViews/0/byteOffset", 18446744073709551615U, "byteOffset"},
        {"//bufferViews/0/byteStride", 16, "byteStride"},
        {"//bufferViews/0/buffer", 1, "buffer"},
        {"//materials/0/pbrMetallicRoughness/baseColorTexture/index", 4, "textures"},
        {"//textures/0/source", nullptr, "source"},
        {"//images/0/bufferView", 0, "images"},
        {"//meshes/0/primitives/0/attributes/TEXCOORD_0", 0, "accessors"},
    };
    for (const Damage& damage : cases) {
        Glb glb = whole;
        const std::string pointer = damage.pointer;
        Json& target = pointer[1] == '/' ? glb.json : glb.json["extensions"]["ESM_spring_mass"];
        target[Json::json_pointer(pointer[1] == '/' ? pointer.substr(1) : pointer)] = damage.value;
        rewrite(glb);
        const std::string message = loadingError();
        EXPECT_THAT(message, testing::AllOf(HasSubstr("organ.glb: "), HasSubstr(damage.named)))
            << damage.pointer << " = " << damage.value;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

/// One picture for many pages would be decoded for each.
TEST_F(ModelPackageFile, PagesHaveAPictureEach) {
    Project project = richProject(24);
    project.texture.atlas = {96, 3, 2};
    project.atlas = std::make_shared<Atlas>(packAtlas(*project.mesh, project.texture.atlas));
    exportPackage(project, m_file);
    Glb glb = parseGlb(readFile(m_file));
    glb.json["textures"][2]["source"] = 1;
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("images/1 is the picture of two pages"));
}

TEST_F(ModelPackageFile, AFinishOfPagesThatAreNotThereIsRefused) {
    Project plain = richProject();
    plain.layers.clear();
    plain.atlas = nullptr;
    plain.texture.finish.emplace();
    exportPackage(plain, m_file);
    Glb glb = parseGlb(readFile(m_file));
    Json& surface = glb.json["materials"][0]["pbrMetallicRoughness"];
    surface["metallicRoughnessTexture"] = {{"index", 0}};
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("without a texture"));
    surface.erase("metallicRoughnessTexture");
    surface["roughnessFactor"] = 1.5;
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("the roughness must be from 0 to 1"));
}

TEST_F(ModelPackageFile, PicturesOfAFinishAreEachOfOnePage) {
    exportPackage(shiningProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    glb.json["textures"][2]["source"] = glb.json["textures"][1]["source"]; // normals
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("is the picture of two pages"));
}

TEST_F(ModelPackageFile, PagesThatDrawATriangleTwiceAreNotDecoded) {
    exportPackage(richProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    Json& drawn = glb.json["extensions"]["ESM_spring_mass"]["drawn"];
    drawn.push_back(drawn[0]);
    glb.json["images"][0]["bufferView"] = 0; // no picture
    rewrite(glb);
    EXPECT_THAT(validatePackage(m_file),
                testing::ElementsAre(HasSubstr("every triangle of the surface once")));
}

TEST_F(ModelPackageFile, ValidationFindsAllProblemsAtOnce) {
    exportPackage(richProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    Json& extension = glb.json["extensions"]["ESM_spring_mass"];
    extension["damping"] = "none";
    extension["springs"]["restLength"] = 9999;
    extension["base"]["mass"] = "heavy";
    rewrite(glb);
    const std::string problems = testing::PrintToString(validatePackage(m_file));
    for (const char* named : {"damping", "restLength", "mass"})
        EXPECT_THAT(problems, HasSubstr(named));
}

TEST_F(ModelPackageFile, WhatRefersToADamagedArrayIsNoFurtherProblem) {
    exportPackage(richProject(), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    for (const char* damaged : {"/nodes/restPosition", "/nodes/mass", "/nodes/viscosity", "/springs/nodes",
                                "/surface/restPosition", "/tethers/nodes"}) {
        Glb glb = whole;
        glb.json["extensions"]["ESM_spring_mass"].at(Json::json_pointer(damaged)) = 9999;
        rewrite(glb);
        EXPECT_THAT(validatePackage(m_file), testing::SizeIs(1)) << damaged;
    }
}

TEST_F(ModelPackageFile, AnUnknownIntegratorIsLeftOutAndNamed) {
    exportPackage(richProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    glb.json["extensions"]["ESM_spring_mass"]["stepping"]["integrator"] = "leapfrog";
    rewrite(glb);
    EXPECT_THAT(validatePackage(m_file), testing::ElementsAre(HasSubstr("leapfrog")));
    const OpenedPackage opened = openPackage(m_file);
    EXPECT_FALSE(opened.package.stepping);
    EXPECT_THAT(opened.warnings, testing::ElementsAre(HasSubstr("leapfrog")));
}

TEST_F(ModelPackageFile, WhatIsMissingIsNamedOnce) {
    exportPackage(richProject(), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    for (const char* missing : {"version", "damping", "surface", "nodes"}) {
        Glb glb = whole;
        glb.json["extensions"]["ESM_spring_mass"].erase(missing);
        rewrite(glb);
        const std::vector<std::string> problems = validatePackage(m_file);
        EXPECT_EQ(std::set<std::string>(problems.begin(), problems.end()).size(), problems.size()) << missing;
        EXPECT_THAT(problems, testing::Contains(HasSubstr(missing + std::string(" is missing"))));
    }
}

TEST_F(ModelPackageFile, WhatIsNoPackageIsRefused) {
    EXPECT_THAT(loadingError(), HasSubstr("does not exist"));
    overwrite(m_file, std::string());
    EXPECT_THAT(loadingError(), HasSubstr("is empty"));
    overwrite(m_file, std::string("PK and more than twelve bytes"));
    EXPECT_THAT(loadingError(), HasSubstr("is not a binary glTF file"));
    overwrite(m_file, writeGlb({Json{{"asset", {{"version", "2.0"}}}}, {0, 0, 0, 0}}));
    EXPECT_THAT(loadingError(), HasSubstr("no model package"));
}

} // namespace
} // namespace esm
